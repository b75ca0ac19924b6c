import { setMaxListeners } from 'node:events';
import { statOrError } from '../files.ts';
import { isStream } from '../read-bytes.ts';
import { catchSignals, hearSignals } from '../signals.ts';
import { type Bail, cutAtBail, FailureCount } from './bail.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';
import { crashedLevel } from './refused-level.ts';
import type { Batch } from './worker.ts';

/** Fewer files than this are checked faster without workers, because starting them takes about as long. */
const MANY_FILES = 64;

/** bytes times the longest run in s; more work than this goes to workers even for few files: Ctrl-C must take effect at once */
const MUCH_WORK = 256 * 1024 * 60;

/** ms of work on the main thread between two checks for signals */
const SLICE = 20;

/**
 * Checks level files.
 * @param jobs the largest number of worker threads; the reports don't depend on it
 * @param onProgress called now and then with the number of files that are done
 * @param bail when to stop before the last file
 * @returns one report for each file, in the same order; with `bail`, those of the first files up to the failing one that was too many
 */
export async function checkFiles(
  files: readonly string[],
  settings: CheckSettings,
  jobs: number,
  onProgress: (done: number) => void,
  bail: Bail | null = null,
): Promise<CheckedLevel[]> {
  const stats = files.map((file) => statOrError(file));
  // reading a pipe may block forever, and a blocked worker can't be ended
  const waiting = files.filter((file, i) => !(stats[i] instanceof Error) && isStream(file, stats[i]));
  const others = new Set(waiting);
  const regular = files.filter((file) => !others.has(file));
  const early = waiting.length === 0 ? [] : await checkWaiting(waiting, settings);

  const bytes = stats.reduce((sum, s) => sum + (s instanceof Error ? 0 : s.size), 0);
  const useWorkers = isLong(settings) || (jobs > 1 && regular.length >= MANY_FILES) || bytes * settings.maxTime > MUCH_WORK;
  const reports = await (useWorkers
    ? checkInWorkers(regular, settings, jobs, onProgress, bail)
    : checkHere(regular, settings, onProgress, bail));
  if (early.length === 0) return cutAtBail(reports, bail);
  const byFile = new Map([...early, ...reports].map((report) => [report.file, report]));
  // where the check stopped early, the rest has no report
  return cutAtBail(
    files.flatMap((file) => byFile.get(file) ?? []),
    bail,
  );
}

/** Whether a level may take seconds. */
const isLong = ({ search, requireSlack }: CheckSettings): boolean => search !== null || requireSlack !== null;

async function checkWaiting(files: readonly string[], settings: CheckSettings): Promise<CheckedLevel[]> {
  const { checkLevel } = await import('./check-level.ts');
  return files.map((file) => checkLevel(file, settings));
}

async function checkHere(
  files: readonly string[],
  settings: CheckSettings,
  onProgress: (done: number) => void,
  bail: Bail | null,
): Promise<CheckedLevel[]> {
  // only the thread that checks loads schema and engine
  const { checkLevel } = await import('./check-level.ts');
  const reports: CheckedLevel[] = [];
  const failures = new FailureCount(bail);
  let listened = performance.now();
  for (const file of files) {
    reports.push(checkLevel(file, settings));
    failures.add(reports.length - 1, reports.slice(-1));
    if (failures.isEnough) break;
    if (performance.now() - listened < SLICE) continue;
    await hearSignals();
    onProgress(reports.length);
    listened = performance.now();
  }
  return reports;
}

async function checkInWorkers(
  files: readonly string[],
  settings: CheckSettings,
  jobs: number,
  onProgress: (done: number) => void,
  bail: Bail | null,
): Promise<CheckedLevel[]> {
  const { Tinypool } = await import('tinypool');
  catchSignals();
  // several batches for each worker, so that none waits long for one with slow levels
  const size = isLong(settings) ? 1 : Math.max(1, Math.min(32, Math.ceil(files.length / (4 * jobs))));
  const threads = Math.min(jobs, Math.ceil(files.length / size));
  const pool = new Tinypool({
    filename: new URL('./worker.js', import.meta.url).href,
    minThreads: threads,
    maxThreads: threads,
    isolateWorkers: false,
  });
  let done = 0;
  const failures = new FailureCount(bail);
  const enough = bail === null ? null : new AbortController();
  // every batch listens
  if (enough !== null) setMaxListeners(0, enough.signal);
  const check = async (batch: readonly string[], number: number): Promise<CheckedLevel[]> => {
    const reports = await runBatch(batch);
    failures.add(number * size, reports);
    if (failures.isEnough) enough?.abort();
    done += batch.length;
    onProgress(done);
    return reports;
  };
  const runBatch = async (batch: readonly string[]): Promise<CheckedLevel[]> => {
    try {
      return await pool.run({ files: batch, settings } satisfies Batch, { signal: enough?.signal });
    } catch (error) {
      if (enough?.signal.aborted) return [];
      if (batch.length === 1) return [crashedLevel(batch[0], error)];
      // the worker died with the whole batch: check its levels one at a time to find the one that kills it
      return (await Promise.all(batch.map((file) => runBatch([file])))).flat();
    }
  };
  try {
    const batches: (readonly string[])[] = [];
    for (let i = 0; i < files.length; i += size) batches.push(files.slice(i, i + size));
    return (await Promise.all(batches.map(check))).flat();
  } finally {
    await pool.destroy();
  }
}
