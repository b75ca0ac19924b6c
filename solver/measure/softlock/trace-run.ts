import type { Hold } from '../../../schema/basics/index.ts';
import type { Steps } from '../../steps.ts';
import type { Examined, RunLoss } from './state.ts';
import type { SurveyTask } from './survey-task.ts';

/** The moment at which a run was lost is found up to this many ticks: by searches, and by proofs. */
const FINE = 3;
const FINE_PROVED = 8;

/** A run while it is found out since when it was lost. */
export interface TracedRun extends RunLoss {
  completes: boolean;
  last: number;
  open: number | null;
  lost: Examined | null;
  proved: Examined | null;
  /** The states that were examined, by tick; null before the run was played. */
  states: Map<number, Examined> | null;
}

export const createTracedRun = (holds: readonly Hold[]): TracedRun => ({
  holds,
  completes: false,
  last: 0,
  open: null,
  lost: null,
  proved: null,
  states: null,
});

function* play(task: SurveyTask, run: TracedRun): Steps<Map<number, Examined>> {
  const { completes, last } = task.playOut(run.holds);
  run.completes = completes;
  run.last = last;
  run.states = new Map();
  if (completes) {
    task.complete(run.holds);
    run.open = last;
  }
  yield null;
  return run.states;
}

function momentOf(task: SurveyTask, run: TracedRun, states: Map<number, Examined>, tick: number): Examined | null {
  const known = states.get(tick);
  if (known !== undefined) return known;
  const state = task.stateAt({ holds: run.holds, tick }, null);
  if (state === null) return null;
  state.alive = run.last - tick;
  states.set(tick, state);
  return state;
}

/**
 * Halves the time between the last moment at which the black hole could be reached and the first from which no run was found.
 * With longer searches it can only come later than before.
 * @param ticks of the search from each moment
 */
export function* dateLoss(task: SurveyTask, run: TracedRun, ticks: number): Steps<void> {
  const states = run.states ?? (yield* play(task, run));
  if (run.completes) return;
  const end = momentOf(task, run, states, run.last);
  if (end === null) return;
  const open = task.lastOpen({ holds: run.holds, tick: run.last });
  let low = Math.max(open ?? -1, run.open ?? -1);
  let lost = end;
  const isOpen = function* (state: Examined): Steps<boolean> {
    yield* task.searchFrom(state, ticks);
    return state.standing.is === 'open';
  };
  // what is proved needs no search, and begins at or after the loss
  const known = run.lost;
  if (run.proved !== null) lost = run.proved;
  if (known !== null && known.tick > low) {
    if (yield* isOpen(known)) low = Math.max(low, known.tick);
    else lost = known;
  } else if (run.proved === null && (yield* isOpen(end))) low = run.last;
  while (lost.tick - low > FINE) {
    const middle = momentOf(task, run, states, Math.floor((low + lost.tick) / 2));
    if (middle === null) break;
    if (yield* isOpen(middle)) low = middle.tick;
    else lost = middle;
  }
  run.open = low < 0 ? null : low;
  run.lost = lost.standing.is === 'open' || lost.tick <= low ? null : lost;
}

/** Halves the time between the loss and the first moment that is proved lost. */
export function* proveLoss(task: SurveyTask, run: TracedRun): Steps<void> {
  const { states, lost } = run;
  if (states === null || lost === null) return;
  const end = momentOf(task, run, states, run.last);
  if (end === null) return;
  const isProved = function* (state: Examined): Steps<boolean> {
    yield* task.prove(state);
    return state.standing.is === 'proved';
  };
  if (yield* isProved(lost)) {
    run.proved = lost;
    return;
  }
  let proved = run.proved ?? end;
  if (!(yield* isProved(proved))) return;
  let low = lost.tick;
  while (proved.tick - low > FINE_PROVED) {
    const middle = momentOf(task, run, states, Math.floor((low + proved.tick) / 2));
    if (middle === null) break;
    if (yield* isProved(middle)) proved = middle;
    else low = middle.tick;
  }
  run.proved = proved;
}
