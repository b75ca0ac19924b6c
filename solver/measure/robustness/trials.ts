import { createSimulation, maxTicksOf, type Scene, type Simulation, type WorkBudget } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { type Goal, mineralsNeeded } from '../../goal.ts';
import { verifyRun } from '../../verified-run.ts';

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
