import type { ResourceLimits } from 'node:worker_threads';
import type { Tinypool } from 'tinypool';
import { catchSignals } from './signals.ts';

/**
 * Starts worker threads.
 * @param filename URL of a module whose default export does one task
 * @param resourceLimits of the memory of each
 */
export async function openPool(filename: URL, threads: number, resourceLimits?: ResourceLimits): Promise<Tinypool> {
  const { Tinypool } = await import('tinypool');
  catchSignals();
  return new Tinypool({
    filename: filename.href,
    minThreads: threads,
    maxThreads: threads,
    isolateWorkers: false,
    resourceLimits,
  });
}

/**
 * Runs tasks in worker threads.
 * @param filename URL of a module whose default export runs one task
 * @param jobs the largest number of threads
 * @param onDone called after each task, in the order in which they end
 * @returns one result for each task, in the same order
 * @throws errors of a task or of `onDone`
 */
export async function runInPool<Task, Result>(
  filename: URL,
  tasks: readonly Task[],
  jobs: number,
  onDone: (done: number, result: Result) => void | Promise<void>,
): Promise<Result[]> {
  const pool = await openPool(filename, Math.max(1, Math.min(jobs, tasks.length)));
  let done = 0;
  const run = async (task: Task): Promise<Result> => {
    const result: Result = await pool.run(task);
    await onDone(++done, result);
    return result;
  };
  try {
    return await Promise.all(tasks.map(run));
  } finally {
    await pool.destroy();
  }
}
