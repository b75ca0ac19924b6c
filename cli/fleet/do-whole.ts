import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { CommandResult } from '../command.ts';
import { type Batch, LineWriter, readSet } from '../io/index.ts';
import type { Destination } from '../reporters/index.ts';
import {
  createStatusLine,
  exitCodeAfter,
  Failure,
  namedPath,
  onSignal,
  type StoppingSignal,
  stoppable,
  systemReason,
} from '../terminal/index.ts';
import { contentsOf, type JobName, type Json, type Records, type ShardRecord } from './job.ts';
import { jobOf, type ReportOptions } from './jobs/index.ts';
import { LineReader } from './line-reader.ts';
import { recordOfLine } from './result.ts';
import { limitsFor } from './run-shard.ts';
import { type Asked, sharedText, workInThreads } from './threads.ts';
import type { Common } from './worker.ts';

/** What has become of a set. */
interface WholeSet {
  /** The records in the order of the set; can be read as often as is wanted until `remove`. */
  readonly records: Records;
  readonly remove: () => void;
  /** The signal that ended the work early; null if none came. */
  readonly signal: StoppingSignal | null;
}

/**
 * Does a whole set in this process, without a plan. Records wait in a temporary file, so memory does not grow with the set.
 * @param paths files and packs
 */
async function doWhole(
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
      return { records: (known) => recordsIn(out.unfinished, known), remove: scratch.remove, signal };
    } catch (error) {
      out.discard();
      throw error;
    }
  } catch (error) {
    scratch.remove();
    throw error;
  }
}

function* recordsIn(path: string, known: Parameters<Records>[0]): Generator<ShardRecord> {
  const reader = new LineReader(path);
  for (let line = reader.next(); line !== null; line = reader.next()) yield known?.(line.toString()) ?? recordOfLine(line);
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${namedPath(path)}: can't be written: ${systemReason(error)}; TMPDIR names another folder`);
  }
}

/** What a set is done with. */
interface WholeOptions extends Omit<ReportOptions, 'withTimes'> {
  /** The largest number of threads. */
  readonly jobs: number;
  /** What the report depends on besides the results. */
  readonly reporting?: Json;
}

/**
 * Does files and packs one after the other, and reports. Memory does not grow with their number.
 * @param doing what is done, for people: `checked`
 */
export async function reportWhole(
  job: JobName,
  settings: object,
  files: readonly string[],
  destinations: readonly Destination[],
  doing: string,
  { jobs, reporting = {}, ...options }: WholeOptions,
): Promise<CommandResult> {
  const line = createStatusLine();
  const { records, remove, signal } = await doWhole(job, settings, files, {
    jobs,
    onProgress: (done) => line.show(`${doing}: ${done}`),
  }).finally(line.clear);
  if (signal !== null) {
    remove();
    return { exitCode: exitCodeAfter(signal) };
  }
  try {
    const report = await jobOf(job).report(records, reporting, destinations, { ...options, withTimes: true });
    return { ...report, end: remove };
  } catch (error) {
    remove();
    throw error;
  }
}

/** A folder for what is too large for memory. */
interface Scratch {
  readonly folder: string;
  /** Removes it; a signal that ends the process does so, too. */
  readonly remove: () => void;
}

/** @throws Failure if there is no place for temporary files */
function openScratch(): Scratch {
  let folder: string;
  try {
    folder = mkdtempSync(join(tmpdir(), 'gq-'));
  } catch (error) {
    throw new Failure(`${tmpdir()}: temporary files can't be written there: ${systemReason(error)}; TMPDIR names another folder`);
  }
  const removeFolder = (): void => rmSync(folder, { recursive: true, force: true });
  const forget = onSignal(removeFolder);
  return {
    folder,
    remove() {
      forget();
      removeFolder();
    },
  };
}
