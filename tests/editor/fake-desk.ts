import type { Desk } from '../../editor/ask/index.ts';
import type { JobEnd, JobKind, Requests, Workers } from '../../editor/workers/index.ts';
import { TurnedClock } from './stage.ts';

/** A job that was started. */
export interface FakeJob {
  readonly kind: JobKind;
  readonly request: unknown;
  readonly tell: (progress: unknown) => void;
  readonly end: (end: JobEnd<unknown>) => void;
  isCancelled: boolean;
}

/** Workers that do nothing by themselves: tests send their messages. */
export class FakeWorkers implements Pick<Workers, 'start'> {
  readonly jobs: FakeJob[] = [];

  start: Workers['start'] = (job, request, onProgress = () => {}) => {
    let resolve: (end: JobEnd<never>) => void = () => {};
    const end = new Promise<JobEnd<never>>((done) => {
      resolve = done;
    });
    const mine: FakeJob = {
      kind: job.name as JobKind,
      request,
      tell: onProgress as (progress: unknown) => void,
      end: resolve as (end: JobEnd<unknown>) => void,
      isCancelled: false,
    };
    this.jobs.push(mine);
    return {
      end,
      cancel() {
        mine.isCancelled = true;
        resolve({ kind: 'cancelled' });
      },
    };
  };

  /** The last job of a kind that was started. */
  last<K extends JobKind>(kind: K) {
    const job = this.jobs.filter((other) => other.kind === kind).at(-1);
    if (job === undefined) throw new Error(`no job of the kind ${kind} was started`);
    return { ...job, request: job.request as Requests[K], isCancelled: () => job.isCancelled };
  }
}

/** A desk with workers that a test answers for; the page rests when its clock has passed. */
export function fakeDesk(): { readonly desk: Desk; readonly workers: FakeWorkers; readonly clock: TurnedClock } {
  const clock = new TurnedClock();
  const workers = new FakeWorkers();
  const after = (ms: number, call: () => void) => clock.after(ms, call);
  return { desk: { workers, afterRest: after, after }, workers, clock };
}
