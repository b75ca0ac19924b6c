import { runInPool } from '../io/index.ts';
import type { TunedLevel, TuneSettings, TuneTask } from './tuned-level.ts';

/**
 * Finds the effects of changed rules on level files in worker threads.
 * @param jobs the largest number of threads
 * @param onProgress called after each file with the number of files that are done
 * @returns one entry for each file, sorted by the smallest change that makes its run fail, then in the order of the files
 */
export async function tuneLevels(
  files: readonly string[],
  settings: TuneSettings,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<TunedLevel[]> {
  const tasks = files.map((file): TuneTask => ({ file, settings }));
  const levels = await runInPool<TuneTask, TunedLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onProgress);
  const roomOf = ({ room }: TunedLevel): number => room ?? Number.POSITIVE_INFINITY;
  return levels.sort((a, b) => (roomOf(a) === roomOf(b) ? 0 : roomOf(a) - roomOf(b)));
}
