import { Worker } from 'node:worker_threads';
import type { Answer, Request, WorkerData } from './settings.ts';

type AnswerOf<K> = Extract<Answer, { kind: K }>;

/** A worker thread that answers requests one after the other. */
export interface Thread {
  /** @throws the error of the thread */
  ask<K extends Request['kind']>(request: Request & { kind: K }, kind: K): Promise<AnswerOf<K>>;
  end(): Promise<unknown>;
}

/** Starts a worker thread that searches. */
export function startThread(workerData: WorkerData): Thread {
  const worker = new Worker(new URL('./worker.js', import.meta.url), { workerData });
  // if the worker has died, the next request throws its error
  let failure: Error | null = null;
  worker.on('error', (error) => {
    failure = error instanceof Error ? error : new Error(String(error));
  });
  let last: Promise<unknown> = Promise.resolve();

  const put = <K extends Answer['kind']>(request: Request, kind: K): Promise<AnswerOf<K>> =>
    new Promise((resolve, reject) => {
      if (failure !== null) return reject(failure);
      const take = (answer: Answer): void => {
        leave();
        if (answer.kind === kind) resolve(answer as AnswerOf<K>);
        else reject(new Error(answer.kind === 'failed' ? answer.why : `asked for ${kind}, a worker gave ${answer.kind}`));
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
    ask(request, kind) {
      const answer = last.then(() => put(request, kind));
      last = answer.catch(() => {});
      return answer;
    },
    end: () => worker.terminate(),
  };
}
