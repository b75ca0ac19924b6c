import type { Job, Steps } from './job.ts';
import { JOBS, type JobKind } from './kinds.ts';
import type { FromWorker, ToWorker } from './protocol.ts';

export interface RunnerOptions {
  readonly post: (message: FromWorker) => void;
  /** Calls back after the messages that have already arrived. */
  readonly later: (call: () => void) => void;
  /** ms */
  readonly now: () => number;
}

/** ms of work between two looks at the messages */
const SLICE = 12;

/** Does jobs one after the other, in slices, so that a cancel takes effect within one. @returns the handler for messages */
export function createRunner({ post, later, now }: RunnerOptions): (message: ToWorker) => void {
  const waiting: Extract<ToWorker, { type: 'start' }>[] = [];
  let current: { readonly job: number; readonly work: Steps<Job> } | null = null;

  let isDue = false;
  const goOn = () => {
    if (isDue) return;
    isDue = true;
    later(slice);
  };
  const slice = () => {
    isDue = false;
    if (current === null) {
      const next = waiting.shift();
      if (next === undefined) return;
      current = { job: next.job, work: JOBS[next.kind as JobKind](next.request as never, now) };
    }
    const { job, work } = current;
    try {
      const until = now() + SLICE;
      do {
        const step = work.next();
        if (step.done === true) {
          current = null;
          post({ type: 'done', job, result: step.value });
          break;
        }
        if (step.value !== null) post({ type: 'progress', job, progress: step.value });
      } while (now() < until);
    } catch (error) {
      current = null;
      post({ type: 'failed', job, message: error instanceof Error ? error.message : String(error) });
    }
    goOn();
  };

  return (message) => {
    if (message.type === 'start') {
      waiting.push(message);
      goOn();
      return;
    }
    const index = waiting.findIndex(({ job }) => job === message.job);
    if (index >= 0) waiting.splice(index, 1);
    else if (current?.job === message.job) current = null;
    else return;
    post({ type: 'cancelled', job: message.job });
  };
}
