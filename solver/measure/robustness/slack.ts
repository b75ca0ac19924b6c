import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import type { Goal } from '../../verified-run.ts';
import { advanceTo, createTrials, playFrom, shiftHolds, type Trials } from './trials.ts';

/**
 * Slack of one press or release: how far it can move alone while the run still meets the goal. Every tick in between succeeds,
 * too.
 */
export interface EdgeSlack {
  /** How much earlier it may come, ticks. */
  readonly earlier: number;
  /** How much later it may come, ticks. */
  readonly later: number;
}

/** The largest shift that is tried, ticks: one second. */
export const SLACK_LIMIT = 60;

/**
 * Measures how far each press and release can move alone. The result is exact: every single shift is simulated.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param limit the largest shift to try, ticks; 60 by default
 * @returns two entries per joined hold: press, release; all 0 for a run that misses the goal
 */
export const findSlack = (scene: Scene, holds: readonly Hold[], goal: Goal, limit = SLACK_LIMIT): EdgeSlack[] =>
  finish(findSlackInSteps(scene, holds, goal, limit));

/**
 * {@link findSlack} in steps of one run.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param limit the largest shift to try, ticks; 60 by default
 * @returns a generator that yields between steps and returns two entries per joined hold
 */
export const findSlackInSteps = (scene: Scene, holds: readonly Hold[], goal: Goal, limit = SLACK_LIMIT): Steps<EdgeSlack[]> =>
  slackOf(createTrials(scene, goal), joinHolds(holds), limit);

/**
 * {@link findSlack} with existing trials, one run per step.
 * @param holds sorted and disjoint
 */
export function* slackOf(trials: Trials, holds: readonly Hold[], limit: number): Steps<EdgeSlack[]> {
  const edges = holds.flat();
  const { simulation } = trials;
  simulation.reset();
  const start = simulation.snapshot();
  if (!playFrom(trials, start, holds)) return edges.map(() => ({ earlier: 0, later: 0 }));

  const shifts = new Array<number>(edges.length).fill(0);
  // Runs that differ only from here on continue from this state.
  let shared = start;
  function* largest(edge: number, direction: number): Steps<number> {
    for (let by = 1; by <= limit; by++) {
      shifts[edge] = by * direction;
      const succeeds = playFrom(trials, shared, shiftHolds(holds, shifts));
      shifts[edge] = 0;
      yield null;
      if (!succeeds) return by - 1;
    }
    return limit;
  }
  const slack: EdgeSlack[] = [];
  for (const [edge, tick] of edges.entries()) {
    shared = stateAt(trials, shared, holds, Math.max(0, tick - limit));
    const earlier = yield* largest(edge, -1);
    const before = shared;
    shared = stateAt(trials, shared, holds, tick);
    const later = yield* largest(edge, 1);
    shared = before;
    slack.push({ earlier, later });
  }
  return slack;
}

/** The state of a run at a tick, computed from an earlier state of it. */
function stateAt(trials: Trials, before: Float64Array, holds: readonly Hold[], tick: number): Float64Array {
  const { simulation } = trials;
  simulation.restore(before);
  for (const [press, release] of holds) {
    advanceTo(trials, Math.min(press, tick), false);
    advanceTo(trials, Math.min(release, tick), true);
  }
  advanceTo(trials, tick, false);
  return simulation.snapshot();
}
