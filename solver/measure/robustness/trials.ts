import { createSimulation, joinHolds, maxTicksOf, type Scene, type Simulation, type WorkBudget } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import { type Goal, mineralsNeeded, verifyRun } from '../../verified-run.ts';

/** What is needed to judge many runs of one scene for one goal: a simulation to reuse, and counters of the cost. */
export interface Trials {
  readonly scene: Scene;
  readonly goal: Goal;
  /** A run fails when it lasts longer than this, ticks. */
  readonly maxTicks: number;
  readonly simulation: Simulation;
  /** Runs judged so far. */
  runs: number;
  /** Ticks simulated so far. */
  ticks: number;
}

/**
 * Creates trials at the start of the scene.
 * @param budget limits the work of all runs together; no limit by default
 */
export function createTrials(scene: Scene, goal: Goal, maxTicks = maxTicksOf(scene.terms), budget?: WorkBudget): Trials {
  return { scene, goal, maxTicks, simulation: createSimulation(scene, budget), runs: 0, ticks: 0 };
}

/** Advances the simulation to `tick`, or to the end of the run if that comes first. */
export function advanceTo(trials: Trials, tick: number, held: boolean): void {
  const { simulation } = trials;
  if (simulation.ending === null && tick > simulation.tick) trials.ticks += simulation.advance(tick - simulation.tick, held);
}

/**
 * Whether the run that the simulation has just played to its end meets the goal.
 * @param holds gives the holds that were played; called only where the simulation alone cannot decide
 */
export function isSuccess(trials: Trials, holds: () => readonly Hold[]): boolean {
  const { simulation, scene, goal, maxTicks } = trials;
  trials.runs++;
  if (simulation.ending?.outcome !== 'completed') return false;
  const count = scene.minerals.count;
  const needed = mineralsNeeded(goal, count);
  if (needed === 0) return true;
  if (simulation.mineralCount < needed) return false;
  let different = 0;
  for (let i = 0; i < count; i++) if (simulation.isCollected(i)) different++;
  if (different >= needed) return true;
  // When several minerals are touched in one frame, `arcade` removes only the last of them. The full record knows them all.
  return verifyRun(scene, holds(), goal, maxTicks) !== null;
}

/**
 * Plays a run to its end from one of its states, and judges it.
 * @param state a snapshot of the run before its end
 * @param holds the whole run, sorted and disjoint; what comes before the snapshot is skipped
 */
export function playFrom(trials: Trials, state: Float64Array, holds: readonly Hold[]): boolean {
  const { simulation, maxTicks } = trials;
  simulation.restore(state);
  for (const [press, release] of holds) {
    advanceTo(trials, Math.min(press, maxTicks), false);
    advanceTo(trials, Math.min(release, maxTicks), true);
  }
  advanceTo(trials, maxTicks, false);
  return isSuccess(trials, () => holds);
}

/**
 * What the game reads when every edge is shifted: ticks below 0 become 0, holds whose release does not come after their press
 * vanish, and holds that overlap or touch join.
 * @param shifts ticks, negative for earlier; two per hold: press, release
 */
export function shiftHolds(holds: readonly Hold[], shifts: ArrayLike<number>): Hold[] {
  return joinHolds(
    holds.map(([press, release], i): Hold => [Math.max(0, press + shifts[2 * i]), Math.max(0, release + shifts[2 * i + 1])]),
  );
}

/** So few that one step takes a few milliseconds in a large level. */
const RUNS_A_STEP = 8;

/**
 * Judges many runs at once. Sorted by their edges, each run continues from the last state that it shares with the one before: a
 * thousand runs that differ by a little noise share their first swings, which are then simulated once.
 * @param runs each sorted and disjoint
 * @returns 1 for each run that meets the goal, else 0, in the order given
 */
export const judgeAll = (trials: Trials, runs: readonly (readonly Hold[])[]): Uint8Array => finish(judgeInSteps(trials, runs));

/** {@link judgeAll}, a few runs per step. */
export function* judgeInSteps(trials: Trials, runs: readonly (readonly Hold[])[]): Steps<Uint8Array> {
  const { simulation, maxTicks } = trials;
  const edges = runs.map((holds) => holds.flat());
  // A run without a next edge sorts behind those that have one.
  const edgeOf = (run: number, depth: number): number => Math.min(edges[run][depth] ?? maxTicks, maxTicks);
  const compare = (a: number, b: number): number => {
    const depth = Math.max(edges[a].length, edges[b].length);
    for (let i = 0; i < depth; i++) {
      const difference = edgeOf(a, i) - edgeOf(b, i);
      if (difference !== 0) return difference;
    }
    return a - b;
  };
  const order = [...runs.keys()].sort(compare);

  const succeeded = new Uint8Array(runs.length);
  // states[d]: the state at edge d of the previous run, before the button changes.
  const states: Float64Array[] = [];
  let before = -1;
  // The previous run had ended by its edge of this depth, so its later edges do not matter.
  let endedAt = 0;
  let judged = 0;
  for (const run of order) {
    if (++judged % RUNS_A_STEP === 0) yield null;
    let depth = 0;
    if (before < 0) simulation.reset();
    else {
      while (depth < endedAt && edgeOf(run, depth) === edgeOf(before, depth)) depth++;
      if (depth === endedAt) {
        succeeded[run] = succeeded[before];
        continue;
      }
      simulation.restore(states[depth]);
    }
    for (; ; depth++) {
      const tick = edgeOf(run, depth);
      advanceTo(trials, tick, depth % 2 === 1);
      states[depth] = simulation.snapshot(states[depth]);
      if (tick === maxTicks || simulation.ending !== null) break;
    }
    endedAt = depth;
    succeeded[run] = isSuccess(trials, () => runs[run]) ? 1 : 0;
    before = run;
  }
  return succeeded;
}
