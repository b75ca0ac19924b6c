import type { JobKind, Progresses, Requests, Results } from './protocol.ts';

/**
 * A job in slices: each step should take only a few ms, and yields a report or null. A part that can't be divided is one long
 * step; cancelling it ends the worker.
 */
export type Work<K extends JobKind> = Generator<Progresses[K] | null, Results[K], void>;

/** Begins a job. @param now a clock, ms */
export type Start<K extends JobKind> = (request: Requests[K], now: () => number) => Work<K>;

/** target duration of a step in ms: a cancel is not received within a step */
const STEP = 12;
const FEWEST_TICKS = 500;
const MOST_TICKS = 2_000_000;

/** Advances something by as many ticks as take about one step; it learns that number. */
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
