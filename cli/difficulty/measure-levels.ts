import { runInPool } from '../io/index.ts';
import type { MeasuredLevel, MeasureSettings, MeasureTask } from './measured-level.ts';
import type { LevelPlays } from './plays/index.ts';

/**
 * Measures the difficulty of level files in worker threads.
 * @param plays the plays of each file; null unless plays are given
 * @param jobs the largest number of threads
 * @param onProgress called after each file with the number of files that are done
 * @returns one report for each file, in the same order
 */
export function measureLevels(
  files: readonly string[],
  settings: MeasureSettings,
  plays: ReadonlyMap<string, LevelPlays> | null,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<MeasuredLevel[]> {
  const tasks = files.map((file): MeasureTask => ({ file, settings, plays: plays?.get(file) ?? null }));
  return runInPool<MeasureTask, MeasuredLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onProgress);
}
