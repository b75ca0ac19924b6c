import { statSync } from 'node:fs';
import { setImmediate } from 'node:timers/promises';
import { checkLevel, crashedLevel } from './check-level.ts';
import type { CheckSettings, LevelReport } from './report.ts';
import type { Batch } from './worker.ts';

/** Fewer files than this are checked faster without workers, which take about as long to start. */
const MANY_FILES = 64;

/** Files larger than this together, in bytes, go to a worker however few they are, so that Ctrl-C is heard at once. */
const MANY_BYTES = 256 * 1024;

/** How long the main thread works before it listens for signals again, ms. */
const SLICE = 20;

/**
 * Checks level files.
 * @param jobs the most worker threads to use; what comes out doesn't depend on it
 * @param onProgress called now and then with how many are done
 * @returns one report a file, in the same order
 */
export async function checkFiles(
  files: readonly string[],
  settings: CheckSettings,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<LevelReport[]> {
  const many = jobs > 1 && files.length >= MANY_FILES;
  return many || areLarge(files) ? checkInWorkers(files, settings, jobs, onProgress) : checkHere(files, settings, onProgress);
}

function areLarge(files: readonly string[]): boolean {
  let total = 0;
  for (const file of files) {
    total += statSync(file, { throwIfNoEntry: false })?.size ?? 0;
    if (total > MANY_BYTES) return true;
  }
  return false;
}

async function checkHere(
  files: readonly string[],
  settings: CheckSettings,
  onProgress: (done: number) => void,
): Promise<LevelReport[]> {
  const reports: LevelReport[] = [];
  let listened = performance.now();
  for (const file of files) {
    reports.push(checkLevel(file, settings));
    if (performance.now() - listened < SLICE) continue;
    await setImmediate();
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
): Promise<LevelReport[]> {
  const { Tinypool } = await import('tinypool');
  // several batches a worker, so that none waits long for another that got the slow levels
  const size = Math.max(1, Math.min(32, Math.ceil(files.length / (4 * jobs))));
  const threads = Math.min(jobs, Math.ceil(files.length / size));
  const pool = new Tinypool({
    filename: new URL('./worker.js', import.meta.url).href,
    minThreads: threads,
    maxThreads: threads,
    isolateWorkers: false,
  });
  let done = 0;
  const check = async (batch: readonly string[]): Promise<LevelReport[]> => {
    const reports = await runBatch(batch);
    done += batch.length;
    onProgress(done);
    return reports;
  };
  const runBatch = async (batch: readonly string[]): Promise<LevelReport[]> => {
    try {
      return await pool.run({ files: batch, settings } satisfies Batch);
    } catch (error) {
      if (batch.length === 1) return [crashedLevel(batch[0], error)];
      // a worker that died took the batch along: one level at a time, the one that kills it stands alone
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
