import { runInPool } from '../pool.ts';
import type { MeasuredLevel, MeasureSettings, MeasureTask } from './measured-level.ts';

/**
 * Measures the difficulty of level files in worker threads.
 * @param jobs the largest number of threads
 * @param onProgress called after each file with the number of files that are done
 * @returns one report for each file, in the same order
 */
export function measureLevels(
  files: readonly string[],
  settings: MeasureSettings,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<MeasuredLevel[]> {
  const tasks = files.map((file): MeasureTask => ({ file, settings }));
  return runInPool<MeasureTask, MeasuredLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onProgress);
}
