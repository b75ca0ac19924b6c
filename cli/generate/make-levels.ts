import { runInPool } from '../io/index.ts';
import type { GenerateTask, MadeLevel } from './make-level.ts';

/**
 * Generates levels in worker threads. Resolves after `onMade` has finished for every level.
 * @param jobs the largest number of threads
 * @param onMade called with each level as soon as it is done
 */
export async function makeLevels(
  tasks: readonly GenerateTask[],
  jobs: number,
  onMade: (done: number, made: MadeLevel) => Promise<void>,
): Promise<void> {
  await runInPool<GenerateTask, MadeLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onMade);
}
