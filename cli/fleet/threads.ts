import { type Batch, entriesOf, openPool, readBytes, runInParts, sizeOf } from '../io/index.ts';
import { contentHash, DIGEST, entryHash, shardOf } from './digest.ts';
import type { ShardRecord } from './job.ts';
import { jobOf } from './jobs/index.ts';
import type { Done, Task } from './worker.ts';

/**
 * MB of each thread. V8 is sparing in a small heap: without limits, the garbage of two threads makes up half the memory of the
 * process. A level may need hundreds of MB, so the larger limit is far above what most need.
 */
const MEMORY = { maxYoungGenerationSizeMb: 16, maxOldGenerationSizeMb: 1024 };

/** Batches that are under way for each thread: one is worked on while others wait. */
const AHEAD = 3;

/** Shares settings between threads. */
export function sharedText(value: unknown): SharedArrayBuffer {
  const bytes = Buffer.from(JSON.stringify(value));
  const shared = new SharedArrayBuffer(bytes.length);
  new Uint8Array(shared).set(bytes);
  return shared;
}

/** A task, and what the caller wants to know with its result. */
export interface Asked<Tag> {
  readonly task: Task;
  readonly tag: Tag;
}

/**
 * Works on batches in threads, several at once, and gives the results in the order of the batches. Memory is bounded by the
 * batches under way.
 * @param stopping ends the threads
 * @param take gets each result
 */
export async function workInThreads<Tag>(
  tasks: AsyncIterable<Asked<Tag>>,
  jobs: number,
  stopping: AbortSignal,
  take: (done: Done, asked: Asked<Tag>) => void,
): Promise<void> {
  const pool = await openPool(new URL('./worker.js', import.meta.url), jobs, MEMORY);
  const stop = (): void => void pool.destroy();
  stopping.addEventListener('abort', stop);
  const underWay: { readonly asked: Asked<Tag>; readonly done: Promise<Done> }[] = [];
  const takeOldest = async (): Promise<void> => {
    const { asked, done } = underWay.shift()!;
    take(await done, asked);
  };
  try {
    for await (const asked of tasks) {
      if (stopping.aborted) return;
      const done = runTask(asked.task);
      // it is awaited later
      done.catch(() => {});
      underWay.push({ asked, done });
      while (underWay.length >= AHEAD * jobs) await takeOldest();
    }
    while (underWay.length > 0) await takeOldest();
  } catch (error) {
    if (!stopping.aborted) throw error;
  } finally {
    stopping.removeEventListener('abort', stop);
    await pool.destroy();
  }

  function runTask(task: Task): Promise<Done> {
    return runInParts((part): Promise<Done> => pool.run(part), task, {
      split: singles,
      join: joined,
      crashed,
      stopped(error) {
        if (stopping.aborted) throw error;
        return null;
      },
    });
  }
}

/** Tasks for each entry of a task. */
function singles({ batch, common, replay }: Task): Task[] {
  return [...Array(sizeOf(batch)).keys()].map((i): Task => {
    const record = replay?.get(i);
    return { batch: only(batch, i), common, ...(replay && { replay: new Map(record === undefined ? [] : [[0, record]]) }) };
  });
}

function only({ first, source }: Batch, i: number): Batch {
  if ('files' in source) return { first: first + i, source: { files: [source.files[i]] } };
  const { labels, bytes, ends } = source;
  const content = bytes.slice(i === 0 ? 0 : ends[i - 1], ends[i]);
  return { first: first + i, source: { ...source, labels: [labels[i]], bytes: content, ends: [content.length] } };
}

function joined(parts: readonly Done[]): Done {
  const hashes = new Uint8Array(DIGEST * parts.length);
  for (const [i, part] of parts.entries()) hashes.set(part.hashes, DIGEST * i);
  return {
    hashes,
    own: parts.flatMap(({ own }, i) => own.map(() => i)),
    lines: parts.flatMap(({ lines }) => lines),
    unreadable: parts.flatMap((part) => part.unreadable),
    changed: parts.flatMap(({ changed }, i) => changed.map(() => i)),
    refuted: new Map(parts.flatMap(({ refuted }, i) => [...refuted.values()].map((truth) => [i, truth] as const))),
  };
}

/** What becomes of a single entry on which a thread has died. */
function crashed({ batch, common, replay }: Task, error: unknown): Done {
  const [{ name, content }] = entriesOf(batch, common.contents, readBytes);
  const isRead = content instanceof Uint8Array;
  const hash = contentHash(isRead ? content : new Uint8Array());
  const isOwn = common.rule === null || shardOf(hash, common.rule) === common.shard;
  const result = jobOf(common.job).crashed(name, error, JSON.parse(Buffer.from(common.settings).toString()));
  const record: ShardRecord = { n: batch.first, file: name, sha256: hash.toString('hex'), ms: 0, result };
  return {
    hashes: entryHash(hash, name),
    own: isOwn ? [0] : [],
    lines: isOwn ? [`${JSON.stringify(record)}\n`] : [],
    unreadable: isRead ? [] : [content.message],
    refuted: new Map(replay === undefined ? [] : [[0, 'crashed']]),
    changed: [],
  };
}
