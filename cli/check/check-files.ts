import { setMaxListeners } from 'node:events';
import { isStream, openPool, runInParts, statOrError } from '../io/index.ts';
import { hearSignals, type StoppingSignal, stoppable } from '../terminal/index.ts';
import type { CheckedFile, checkTogether } from './check-level.ts';
import { type CheckedLevel, type CheckSettings, crashedLevel } from './checked-level.ts';
import type { LevelCache } from './level-cache.ts';
import type { Batch } from './worker.ts';

/** Fewer files than this are checked faster without workers, because starting them takes about as long. */
const MANY_FILES = 64;

/** bytes times the longest run in s; more work than this goes to workers even for few files: Ctrl-C must take effect at once */
const MUCH_WORK = 256 * 1024 * 60;

/** ms of work on the main thread between two checks for signals */
const SLICE = 20;

/** What a check may do without. */
interface Shortcuts {
  /** When to stop before the last file. */
  readonly bail?: Bail | null;
  /** Has the reports of earlier checks, and gets the new ones. */
  readonly cache?: LevelCache | null;
}

/** What became of the files of a check. */
interface CheckedFiles {
  /** In the order of the files. */
  readonly levels: readonly CheckedLevel[];
  /** The files that were not checked, because the check ended early. */
  readonly unchecked: readonly string[];
  /** The signal that ended the check early; null if none came. */
  readonly signal: StoppingSignal | null;
}

/**
 * Checks level files. A check that may take long is stopped by the first signal, with what is checked; a signal ends the process
 * during any other.
 * @param jobs the largest number of worker threads; the reports don't depend on it
 * @param onProgress called now and then with the number of files that are done
 * @returns what became of the files: one report for each, in the same order; with `bail`, those of the first files up to the failing
 *   one that was too many; after a signal, those that were checked
 */
export async function checkFiles(
  files: readonly string[],
  settings: CheckSettings,
  jobs: number,
  onProgress: (done: number) => void,
  { bail = null, cache = null }: Shortcuts = {},
): Promise<CheckedFiles> {
  const stats = files.map((file) => statOrError(file));
  // reading a pipe may block forever, and a blocked worker can't be ended
  const waiting = files.filter((file, i) => !(stats[i] instanceof Error) && isStream(file, stats[i]));
  const early = waiting.length === 0 ? [] : await checkWaiting(waiting, settings);
  const streams = new Set(waiting);
  const known = new Map(cache?.recall(files.filter((file) => !streams.has(file))));
  for (const level of early) known.set(level.file, level);

  const places = unknownPlaces(files, known, bail);
  const unknown = places.map((i) => files[i]);
  const failures = new FailureCount(bail);
  for (const [i, file] of files.entries()) if (known.has(file)) failures.add(i, [known.get(file)!]);
  const bytes = places.map((i) => stats[i]).reduce((sum, s) => sum + (s instanceof Error ? 0 : s.size), 0);
  const useWorkers = isLong(settings) || (jobs > 1 && unknown.length >= MANY_FILES) || bytes * settings.terms.maxTime > MUCH_WORK;
  const work = { settings, cacheKey: cache?.key ?? null };
  const checking: Checking = {
    jobs,
    onProgress: (done) => onProgress(files.length - unknown.length + done),
    isEnough(first, levels) {
      for (const [k, level] of levels.entries()) failures.add(places[first + k], [level]);
      return failures.isEnough;
    },
  };
  const inWorkers = (stopping: AbortSignal | null) => checkInWorkers(unknown, work, checking, stopping);
  const { done, signal } = isLong(settings)
    ? await stoppable(inWorkers)
    : { done: await (useWorkers ? inWorkers(null) : checkHere(unknown, work, checking)), signal: null };
  // nothing is written after a signal
  if (signal === null) {
    for (const { kept } of done) if (kept !== null) cache?.keep(kept);
    await cache?.save();
  }

  for (const { level } of done) known.set(level.file, level);
  // where the check ended early, the rest has no report
  const levels = cutAtBail(
    files.flatMap((file) => known.get(file) ?? []),
    bail,
  );
  const checked = new Set(levels.map(({ file }) => file));
  return { levels, unchecked: files.filter((file) => !checked.has(file)), signal };
}

/** The indices of the files that must be checked, up to where known levels alone end the check. */
function unknownPlaces(files: readonly string[], known: ReadonlyMap<string, CheckedLevel>, bail: Bail | null): number[] {
  let failing = 0;
  const isLast = (level: CheckedLevel | undefined): boolean =>
    bail !== null && level !== undefined && bail.fails(level) && ++failing >= bail.most;
  const last = files.findIndex((file) => isLast(known.get(file)));
  return [...files.keys()].filter((i) => !known.has(files[i]) && (last < 0 || i < last));
}

/** How files are checked, whatever does it. */
interface Checking {
  /** The largest number of worker threads. */
  readonly jobs: number;
  /** Called now and then with the number of files that are done. */
  readonly onProgress: (done: number) => void;
  /** Called with the results of files that follow one another: whether enough levels have failed. */
  readonly isEnough: (first: number, levels: readonly CheckedLevel[]) => boolean;
}

/** Checks a content as if it were that of a file; nothing is read or cached. */
export async function checkContent(file: string, content: Uint8Array, settings: CheckSettings): Promise<CheckedLevel> {
  const { checkLevel } = await import('./check-level.ts');
  return checkLevel(file, settings, content);
}

/** Whether a level may take seconds. */
const isLong = ({ search, requireSlack }: CheckSettings): boolean => search !== null || requireSlack !== null;

async function checkWaiting(files: readonly string[], settings: CheckSettings): Promise<CheckedLevel[]> {
  const { checkLevel } = await import('./check-level.ts');
  return files.map((file) => checkLevel(file, settings));
}

async function checkHere(
  files: readonly string[],
  { settings, cacheKey }: Omit<Batch, 'files'>,
  { onProgress, isEnough }: Checking,
): Promise<CheckedFile[]> {
  if (files.length === 0) return [];
  // only the thread that checks loads schema and engine
  const { checkTogether } = await import('./check-level.ts');
  const reports: CheckedFile[] = [];
  let listened = performance.now();
  for (const file of files) {
    const [report] = checkTogether([{ file }], settings, cacheKey);
    reports.push(report);
    if (isEnough(reports.length - 1, [report.level])) break;
    if (performance.now() - listened < SLICE) continue;
    await hearSignals();
    onProgress(reports.length);
    listened = performance.now();
  }
  return reports;
}

async function checkInWorkers(
  files: readonly string[],
  work: Omit<Batch, 'files'>,
  { jobs, onProgress, isEnough }: Checking,
  stopping: AbortSignal | null,
): Promise<CheckedFile[]> {
  if (files.length === 0) return [];
  // several batches for each worker, so that none waits long for one with slow levels
  const size = isLong(work.settings) ? 1 : Math.max(1, Math.min(32, Math.ceil(files.length / (4 * jobs))));
  const threads = Math.min(jobs, Math.ceil(files.length / size));
  const pool = await openPool(new URL('./worker.js', import.meta.url), threads);
  let done = 0;
  const enough = new AbortController();
  // every batch listens
  setMaxListeners(0, enough.signal);
  const check = async (batch: readonly string[], number: number): Promise<CheckedFile[]> => {
    const reports = await runBatch(batch);
    const levels = reports.map(({ level }) => level);
    if (isEnough(number * size, levels)) enough.abort();
    done += levels.length;
    onProgress(done);
    return reports;
  };
  const runBatch = (batch: readonly string[]): Promise<CheckedFile[]> =>
    runInParts(
      (part): Promise<CheckedFile[]> => pool.run({ files: part, ...work } satisfies Batch, { signal: enough.signal }),
      batch,
      {
        split: (files) => files.map((file) => [file]),
        join: (reports) => reports.flat(),
        crashed: ([file], error) => [{ level: crashedLevel(file, error, work.settings.terms), kept: null }],
        stopped: () => (stopping?.aborted || enough.signal.aborted ? [] : null),
      },
    );
  // ends the workers, which rejects what they have not finished
  const stop = (): void => void pool.destroy();
  stopping?.addEventListener('abort', stop);
  try {
    if (stopping?.aborted) return [];
    const batches: (readonly string[])[] = [];
    for (let i = 0; i < files.length; i += size) batches.push(files.slice(i, i + size));
    return (await Promise.all(batches.map(check))).flat();
  } finally {
    stopping?.removeEventListener('abort', stop);
    await pool.destroy();
  }
}

/** When to stop before all levels are checked. */
interface Bail {
  /** The number of failing levels after which no other is checked. */
  readonly most: number;
  /** Whether a level fails. */
  readonly fails: (level: CheckedLevel) => boolean;
}

/**
 * Counts failing levels in the order of their files, whatever the order in which they are checked. So the same levels are reported
 * for any number of threads.
 */
class FailureCount {
  private readonly levels: (CheckedLevel | undefined)[] = [];
  private next = 0;
  private failing = 0;

  constructor(private readonly bail: Bail | null) {}

  /** Whether enough levels have failed, without a gap before them. */
  get isEnough(): boolean {
    return this.bail !== null && this.failing >= this.bail.most;
  }

  /** Adds the results of files that follow one another. @param first the index of the first of them */
  add(first: number, levels: readonly CheckedLevel[]): void {
    if (this.bail === null) return;
    for (const [i, level] of levels.entries()) this.levels[first + i] = level;
    for (let level = this.levels[this.next]; level !== undefined && !this.isEnough; level = this.levels[++this.next])
      if (this.bail.fails(level)) this.failing++;
  }
}

/** The levels up to the last one that may fail. */
export function cutAtBail(levels: readonly CheckedLevel[], bail: Bail | null): CheckedLevel[] {
  if (bail === null) return [...levels];
  let failing = 0;
  const last = levels.findIndex((level) => bail.fails(level) && ++failing >= bail.most);
  return last < 0 ? [...levels] : levels.slice(0, last + 1);
}

/** Loads what checks a level, and with it the engine: only for the thread that checks. */
export const levelChecker = async (): Promise<typeof checkTogether> => (await import('./check-level.ts')).checkTogether;
