import { runInPool } from '../pool.ts';
import type { GenerateTask, MadeLevel } from './make-level.ts';

/**
 * Makes levels in worker threads.
 * @param jobs the most threads
 * @param onMade called with each as it is done; the levels are made when it has ended for all
 */
export async function makeLevels(
  tasks: readonly GenerateTask[],
  jobs: number,
  onMade: (done: number, made: MadeLevel) => Promise<void>,
): Promise<void> {
  await runInPool<GenerateTask, MadeLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onMade);
}
