import { join } from 'node:path';
import {
  type Batch,
  Failure,
  LineWriter,
  namedPath,
  readSet,
  type StoppingSignal,
  stoppable,
  systemReason,
} from '../io/index.ts';
import type { ShardRecord } from './job.ts';
import { contentsOf, type JobName } from './job-names.ts';
import { jobOf } from './jobs/index.ts';
import { LineReader } from './line-reader.ts';
import { recordOfLine } from './result.ts';
import { limitsFor } from './run-shard.ts';
import { openScratch } from './scratch.ts';
import { type Asked, sharedText, workInThreads } from './threads.ts';
import type { Common } from './worker.ts';

/** What has become of a set. */
export interface WholeSet {
  /** The records in the order of the set; can be read as often as is wanted until `remove`. */
  readonly records: () => Iterable<ShardRecord>;
  readonly remove: () => void;
  /** The signal that ended the work early; null if none came. */
  readonly signal: StoppingSignal | null;
}

/**
 * Does a whole set in this process, without a plan. Records wait in a temporary file, so memory does not grow with the set.
 * @param paths files and packs
 */
export async function doWhole(
  job: JobName,
  settings: object,
  paths: readonly string[],
  { jobs, onProgress }: { readonly jobs: number; readonly onProgress: (done: number) => void },
): Promise<WholeSet> {
  const scratch = openScratch();
  try {
    const contents = contentsOf(job);
    const common: Common = { job, contents, settings: sharedText(settings), rule: null, shard: 0 };
    const path = join(scratch.folder, 'records.ndjson');
    const out = tryTo(path, () => new LineWriter(path));
    let done = 0;
    async function* tasks(): AsyncGenerator<Asked<Batch>> {
      const isLong = jobOf(job).isLong(settings as Record<string, unknown>);
      for await (const batch of readSet(paths, contents, limitsFor(isLong))) yield { task: { batch, common }, tag: batch };
    }
    try {
      const { signal } = await stoppable((stopping) =>
        workInThreads(tasks(), jobs, stopping, ({ lines }) => {
          tryTo(path, () => {
            for (const line of lines) out.write(line);
          });
          done += lines.length;
          onProgress(done);
        }),
      );
      tryTo(path, () => out.end());
      return { records: () => recordsIn(out.unfinished), remove: scratch.remove, signal };
    } catch (error) {
      out.discard();
      throw error;
    }
  } catch (error) {
    scratch.remove();
    throw error;
  }
}

function* recordsIn(path: string): Generator<ShardRecord> {
  const reader = new LineReader(path);
  for (let line = reader.next(); line !== null; line = reader.next()) yield recordOfLine(line);
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${namedPath(path)}: can't be written: ${systemReason(error)}; TMPDIR names another folder`);
  }
}
