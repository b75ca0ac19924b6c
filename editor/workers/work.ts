import type { JobKind, Progresses, Requests, Results } from './protocol.ts';

/**
 * A job in slices: each step should take no more than some ms, and yields what there is to tell, or null. What can't be cut is one long step;
 * cancelling it then ends the worker.
 */
export type Work<K extends JobKind> = Generator<Progresses[K] | null, Results[K], void>;

/** Begins a job. @param now a clock, ms */
export type Start<K extends JobKind> = (request: Requests[K], now: () => number) => Work<K>;

/** How long a step should take, ms: within it a cancel is not heard. */
const STEP = 12;
const FEWEST_TICKS = 500;
const MOST_TICKS = 2_000_000;

/** Advances something by as many ticks as take about one step; it learns how many those are. */
export function createPacer(now: () => number): (advance: (ticks: number) => void) => void {
  let ticks = 5000;
  return (advance) => {
    const start = now();
    advance(ticks);
    const took = now() - start;
    const factor = took > 0 ? STEP / took : 2;
    ticks = Math.round(Math.min(MOST_TICKS, Math.max(FEWEST_TICKS, ticks * Math.min(2, Math.max(0.25, factor)))));
  };
}
