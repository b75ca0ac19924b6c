interface PoolOptions<Result> {
  /** Called after each task, in the order in which they end. */
  readonly onDone: (done: number, result: Result) => void;
  /** Ends the work: tasks that are not done by then are dropped. */
  readonly stop?: AbortSignal;
}

/**
 * Does tasks in worker threads.
 * @param filename URL of a module whose default export does one task
 * @param jobs the most threads
 * @returns one result a task, in the same order; shorter when it was stopped
 * @throws what a task threw
 */
export async function runInPool<Task, Result>(
  filename: URL,
  tasks: readonly Task[],
  jobs: number,
  { onDone, stop }: PoolOptions<Result>,
): Promise<Result[]> {
  const { Tinypool } = await import('tinypool');
  // who asked for the end meanwhile is not told of later
  if (stop?.aborted) return [];
  const threads = Math.max(1, Math.min(jobs, tasks.length));
  const pool = new Tinypool({ filename: filename.href, minThreads: threads, maxThreads: threads, isolateWorkers: false });
  let done = 0;
  const run = async (task: Task): Promise<Result | null> => {
    try {
      const result: Result = await pool.run(task);
      if (stop?.aborted) return null;
      onDone(++done, result);
      return result;
    } catch (error) {
      // ending the threads fails what they were at
      if (stop?.aborted) return null;
      throw error;
    }
  };
  const end = () => void pool.destroy();
  stop?.addEventListener('abort', end);
  try {
    const results = await Promise.all(tasks.map(run));
    return results.filter((result): result is Awaited<Result> & Result => result !== null);
  } finally {
    stop?.removeEventListener('abort', end);
    await pool.destroy();
  }
}
