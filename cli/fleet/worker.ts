import { type Batch, type Contents, type Entry, entriesOf, readBytes, sizeOf } from '../io/index.ts';
import { contentHash, DIGEST, entryHash, type Rule, shardOf } from './digest.ts';
import type { ShardRecord, Work } from './job.ts';
import { jobOf } from './jobs/index.ts';

/** What all tasks of a thread have in common. */
export interface Common {
  readonly job: string;
  readonly contents: Contents;
  /** The settings as JSON, shared between threads. */
  readonly settings: SharedArrayBuffer;
  /** null: all entries count. */
  readonly rule: Rule | null;
  readonly shard: number;
}

/** A message to a worker. */
export interface Task {
  readonly batch: Batch;
  readonly common: Common;
  /** Records whose claims are replayed, in place of working; by their index in the batch. */
  readonly replay?: ReadonlyMap<number, ShardRecord>;
}

/** What a thread has done with a batch. */
export interface Done {
  /** The hashes of all entries, one after the other. */
  readonly hashes: Uint8Array;
  /** The indices of the entries that are of the shard. */
  readonly own: readonly number[];
  /** A record for each of these, as text with a line break. */
  readonly lines: readonly string[];
  /** Files that can't be read: why. */
  readonly unreadable: readonly string[];
  /** Records that a replay has refuted: what is true. */
  readonly refuted: ReadonlyMap<number, string>;
  /** The indices of entries that have other bytes than their records say. */
  readonly changed: readonly number[];
}

let opened: { readonly job: string; readonly settings: Uint8Array; readonly work: Promise<Work> } | null = null;

/** Opened once: all tasks of a thread have the same job, as a rule. */
function workOf({ job, settings }: Common): Promise<Work> {
  const bytes = Buffer.from(settings);
  if (opened === null || opened.job !== job || !bytes.equals(opened.settings)) {
    const text = bytes.toString();
    opened = { job, settings: Buffer.from(text), work: jobOf(job).openWork(JSON.parse(text)) };
  }
  return opened.work;
}

/** An entry that is to be worked on, and its index in the batch. */
interface Waiting {
  readonly i: number;
  readonly entry: Entry;
  readonly sha256: string;
}

/** Bytes of entries that are worked on together. */
const MOST_WAITING = 256 * 1024;

/** Runs in a worker thread: works on the entries of a batch that are of its shard. */
export default async function workOnBatch({ batch, common, replay }: Task): Promise<Done> {
  const { contents, rule, shard } = common;
  const { work: workOn, replay: replayOne } = await workOf(common);
  const hashes = new Uint8Array(DIGEST * sizeOf(batch));
  const own: number[] = [];
  const lines: string[] = [];
  const unreadable: string[] = [];
  const refuted = new Map<number, string>();
  const changed: number[] = [];
  let waiting: Waiting[] = [];
  let bytes = 0;
  const workOnWaiting = async (): Promise<void> => {
    const worked = await workOn(waiting.map(({ entry }) => entry));
    for (const [k, { i, entry, sha256 }] of waiting.entries()) {
      own.push(i);
      const { ms, result } = worked[k];
      const done: ShardRecord = { n: batch.first + i, file: entry.name, sha256, ms, result };
      lines.push(`${JSON.stringify(done)}\n`);
    }
    waiting = [];
    bytes = 0;
  };
  let i = -1;
  for (const entry of entriesOf(batch, contents, readBytes)) {
    i++;
    const { name, content } = entry;
    const record = replay?.get(i);
    if (replay !== undefined && record === undefined) continue;
    const isRead = content instanceof Uint8Array;
    if (!isRead) unreadable.push(content.message);
    const hash = contentHash(isRead ? content : new Uint8Array());
    const sha256 = hash.toString('hex');
    if (record !== undefined) {
      const isSame = isRead && sha256 === record.sha256;
      const truth = isSame ? await replayOne(entry, record.result) : null;
      if (!isSame) changed.push(i);
      if (truth !== null) refuted.set(i, truth);
      continue;
    }
    hashes.set(entryHash(hash, name), DIGEST * i);
    if (rule !== null && shardOf(hash, rule) !== shard) continue;
    waiting.push({ i, entry, sha256 });
    if (isRead) bytes += content.length;
    if (bytes > MOST_WAITING) await workOnWaiting();
  }
  await workOnWaiting();
  return { hashes, own, lines, unreadable, refuted, changed };
}
