import type { ResourceLimits } from 'node:worker_threads';
import type { Tinypool } from 'tinypool';
import { catchSignals } from '../terminal/index.ts';

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

/** How a task of several parts goes on when the thread that works on it dies. */
export interface Parts<Task, Result> {
  /** A task for each part. */
  readonly split: (task: Task) => readonly Task[];
  /** The result of a task from those of its parts. */
  readonly join: (results: readonly Result[]) => Result;
  /** What becomes of a single part on which a thread has died. */
  readonly crashed: (part: Task, error: unknown) => Result;
  /** The result if the work was stopped, so that the error means nothing; null if it was not. May throw. */
  readonly stopped: (error: unknown) => Result | null;
}

/**
 * Runs a task in a thread. Where the thread dies with it, its parts run one at a time, to find the one that kills a thread; the
 * others have their results all the same.
 */
export async function runInParts<Task, Result>(
  run: (task: Task) => Promise<Result>,
  task: Task,
  parts: Parts<Task, Result>,
): Promise<Result> {
  try {
    return await run(task);
  } catch (error) {
    const stopped = parts.stopped(error);
    if (stopped !== null) return stopped;
    const tasks = parts.split(task);
    if (tasks.length === 1) return parts.crashed(task, error);
    return parts.join(await Promise.all(tasks.map((part) => runInParts(run, part, parts))));
  }
}

/** A worker thread with a state of its own, which answers requests one after the other. */
export interface Thread<Request, Answer> {
  /** @throws the error of the thread if it has died */
  ask(request: Request): Promise<Answer>;
  end(): Promise<unknown>;
}

/**
 * Starts a thread that keeps a state between requests, which no thread of a pool does.
 * @param filename URL of a module that answers each message with one
 */
export async function startThread<Request, Answer>(filename: URL, workerData: unknown): Promise<Thread<Request, Answer>> {
  // loaded only by who needs it
  const { Worker } = await import('node:worker_threads');
  const worker = new Worker(filename, { workerData });
  // if the worker has died, the next request throws its error
  let failure: Error | null = null;
  worker.on('error', (error) => {
    failure = error instanceof Error ? error : new Error(String(error));
  });
  let last: Promise<unknown> = Promise.resolve();

  const put = (request: Request): Promise<Answer> =>
    new Promise((resolve, reject) => {
      if (failure !== null) return reject(failure);
      const take = (answer: Answer): void => {
        leave();
        resolve(answer);
      };
      const gone = (code: number): void => {
        leave();
        reject(failure ?? new Error(`a worker thread ended with code ${code} before it answered`));
      };
      const leave = (): void => {
        worker.off('message', take);
        worker.off('exit', gone);
      };
      worker.on('message', take);
      worker.on('exit', gone);
      worker.postMessage(request);
    });

  return {
    ask(request) {
      const answer = last.then(() => put(request));
      last = answer.catch(() => {});
      return answer;
    },
    end: () => worker.terminate(),
  };
}
