import { createHash } from 'node:crypto';
import FlatQueue from 'flatqueue';
import { type Batch, readSet, sizeOf } from '../io/index.ts';
import { Failure, namedPath } from '../terminal/index.ts';
import { contentsOf, type ShardRecord } from './job.ts';
import { jobOf } from './jobs/index.ts';
import { LineReader } from './line-reader.ts';
import type { Plan } from './plan.ts';
import { recordOfLine } from './result.ts';
import { limitsFor } from './run-shard.ts';
import { setPaths } from './set-paths.ts';
import { type Asked, sharedText, workInThreads } from './threads.ts';
import type { Common } from './worker.ts';

/** What replays of a sample have shown. */
interface Replayed {
  readonly replayed: number;
  /** Records that are not true. */
  readonly refuted: readonly { readonly file: string; readonly truth: string }[];
}

/** Refuted records that are kept. */
const MOST_REFUTED = 20;

/**
 * Repeats what a sample of the records claims.
 * @param rate the share of the records in the sample, 0 to 1
 * @param seed chooses the sample; known only when all results are written
 * @throws Failure if the set is no longer that of the plan
 */
export async function replaySample(
  plan: Plan,
  results: readonly string[],
  {
    rate,
    seed,
    jobs,
    stopping,
  }: { readonly rate: number; readonly seed: string; readonly jobs: number; readonly stopping: AbortSignal },
): Promise<Replayed> {
  if (rate === 0) return { replayed: 0, refuted: [] };
  const { job } = plan;
  await jobOf(job).expectInputs?.(plan.settings);
  const contents = contentsOf(job);
  const paths = await setPaths(plan.paths, plan.ignore, contents);
  const common: Common = { job, contents, settings: sharedText(plan.settings), rule: null, shard: 0 };
  const records = mergedRecords(results);
  let replayed = 0;
  let found = 0;
  const refuted: { file: string; truth: string }[] = [];

  async function* tasks(): AsyncGenerator<Asked<ReadonlyMap<number, ShardRecord>>> {
    for await (const batch of readSet(paths, contents, limitsFor(false))) {
      const replay = chosen(batch);
      found += sizeOf(batch);
      if (replay.size > 0) yield { task: { batch, common, replay }, tag: replay };
    }
    // a level that is gone would be neither repeated nor missed
    if (found !== plan.levels) throw otherSet(`it has ${found} ${contents}, ${plan.levels} were planned`);
  }

  function chosen(batch: Batch): Map<number, ShardRecord> {
    const replay = new Map<number, ShardRecord>();
    for (let i = 0; i < sizeOf(batch); i++) {
      const { value, done } = records.next();
      if (done || !isSampled(batch.first + i)) continue;
      const record = recordOfLine(value);
      if (jobOf(plan.job).isClaim(record.result)) replay.set(i, record);
    }
    return replay;
  }

  const isSampled = (n: number): boolean =>
    rate === 1 || createHash('sha256').update(seed).update(`\n${n}`).digest().readUInt32BE(0) < rate * 2 ** 32;

  await workInThreads(tasks(), jobs, stopping, (done, { tag }) => {
    const [first] = done.changed;
    if (done.unreadable.length > 0) throw otherSet(done.unreadable.join('\n'));
    if (first !== undefined) throw otherSet(`${namedPath(tag.get(first)!.file)} is not as planned`);
    replayed += tag.size;
    for (const [i, truth] of done.refuted) if (refuted.length < MOST_REFUTED) refuted.push({ file: tag.get(i)!.file, truth });
  });
  return { replayed, refuted };
}

const otherSet = (why: string): Failure =>
  new Failure(
    `no result was repeated, as the set is no longer that of the plan: ${why}: a level has changed, is missing or is new; restore it, or merge with --replay none`,
  );

/** Bytes of all results that are in memory at a time, about. */
const MEMORY = 64 * 1024 * 1024;

const LEAST_PIECE = 8 * 1024;
const MOST_PIECE = 256 * 1024;

const NUMBER = /^\{"n":(\d+),/;

/**
 * The records of results in the order of the set.
 * @param results whole results that have each record once between them
 * @throws Error if a number is missing or double
 */
export function* mergedRecords(results: readonly string[]): Generator<Buffer> {
  const piece = Math.max(LEAST_PIECE, Math.min(MOST_PIECE, Math.floor(MEMORY / results.length)));
  const readers = results.map((path) => new LineReader(path, piece));
  const lines: (Buffer | null)[] = [];
  const queue = new FlatQueue<number>();
  const advance = (i: number): void => {
    const line = readers[i].next();
    lines[i] = line;
    const number = line === null ? null : NUMBER.exec(line.toString('latin1', 0, 32));
    // the line of the end has no number
    if (number != null) queue.push(i, Number(number[1]));
  };
  for (const [i, reader] of readers.entries()) {
    reader.next();
    advance(i);
  }
  for (let expected = 0; ; expected++) {
    const n = queue.peekValue();
    if (n === undefined) return;
    if (n !== expected) throw new Error(`expected record ${expected}, found ${n}`);
    const i = queue.pop()!;
    yield lines[i]!;
    advance(i);
  }
}
