import type { AnswerOf, AskedOf, Job, ProgressOf, Steps, Work } from './job.ts';
import * as jobs from './jobs/index.ts';
import type { FromWorker, ToWorker } from './workers.ts';

interface RunnerOptions {
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

/** All records of jobs, by name. */
type Records = { [K in keyof typeof jobs as (typeof jobs)[K] extends Job ? K : never]: (typeof jobs)[K] };

export type JobKind = keyof Records;

/** What is asked of a worker, by kind. */
export type Requests = { [K in JobKind]: AskedOf<Records[K]> };
/** What it answers. */
export type Results = { [K in JobKind]: AnswerOf<Records[K]> };
/** What it reports on the way. */
type Progresses = { [K in JobKind]: ProgressOf<Records[K]> };

const all: readonly unknown[] = Object.values(jobs);
const isWork = (value: unknown): value is Work<Job> => typeof value === 'object' && value !== null && 'steps' in value;

/** How each job is done. Only a worker loads it. */
export const JOBS = Object.fromEntries(all.filter(isWork).map(({ of, steps }) => [of.name, steps])) as {
  readonly [K in JobKind]: (asked: Requests[K], now: () => number) => Generator<Progresses[K] | null, Results[K], void>;
};
