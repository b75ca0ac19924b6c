import { runInPool } from '../pool.ts';
import type { TunedLevel, TuneSettings, TuneTask } from './tuned-level.ts';

/**
 * Looks what changes of rules do to level files, in worker threads.
 * @param jobs the most threads
 * @param onProgress called after each file with how many are done
 * @returns one entry a file, those first whose run fails first; of equals in the order of the files
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
