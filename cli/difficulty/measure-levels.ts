import { runInPool } from '../pool.ts';
import type { MeasuredLevel, MeasureSettings, MeasureTask } from './measured-level.ts';

/**
 * Measures how hard level files are, in worker threads.
 * @param jobs the most threads
 * @param onProgress called after each file with how many are done
 * @returns one report a file, in the same order
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
