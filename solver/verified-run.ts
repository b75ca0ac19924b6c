import { createSimulation, DEFAULT_MAX_TIME, joinHolds, playScript, type Scene, simulate, TICK_RATE } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import { type Goal, mineralsNeeded } from './goal.ts';

/** A run that meets its goal: a replay from the start has shown it. */
export interface Candidate {
  /** [press, release) in ticks, sorted, disjoint, none after the end */
  readonly holds: readonly Hold[];
  /** The tick in which she reaches the black hole. */
  readonly tick: number;
  /** When, s from the start. */
  readonly time: number;
  /** Indices of the minerals collected on the way: different ones, sorted. */
  readonly minerals: readonly number[];
}

/** Replays scripts of one scene from the start, one after the other: what `verifyRun` does, for many runs. */
export interface Replay {
  /** Ticks simulated so far. */
  readonly ticks: number;
  /**
   * The run when it meets the goal in time, else null.
   * @param within ticks in which it must, where that is less than for all runs
   */
  play(holds: readonly Hold[], within?: number): Candidate | null;
}

/** How long a run may last where nothing else is said, ticks. */
export const DEFAULT_MAX_TICKS = DEFAULT_MAX_TIME * TICK_RATE;

/** The holds without what comes after the tick in which the run ended. */
export function cutHolds(holds: readonly Hold[], tick: number): Hold[] {
  return holds.filter(([press]) => press <= tick).map(([press, release]) => [press, Math.min(release, tick + 1)]);
}

/**
 * Replays scripts as `simulate` does, with the same bits, but keeps no recording: several times as fast.
 * @param maxTicks how long a run may last
 */
export function createReplay(scene: Scene, goal: Goal, maxTicks: number = DEFAULT_MAX_TICKS): Replay {
  const simulation = createSimulation(scene);
  const needed = mineralsNeeded(goal, scene.minerals.count);
  let ticks = 0;

  /** Plays to the end; the indices of the minerals, or null when it misses the goal. */
  const mineralsOf = (holds: readonly Hold[], within: number): number[] | null => {
    simulation.reset();
    playScript(simulation, holds, within);
    ticks += simulation.tick;
    if (simulation.ending?.outcome !== 'completed') return null;
    const minerals: number[] = [];
    for (let i = 0; i < scene.minerals.count; i++) if (simulation.isCollected(i)) minerals.push(i);
    // of minerals touched at once arcade counts all and takes one away: only its events know which she had
    const all = minerals.length === simulation.mineralCount ? minerals : countedMinerals(scene, holds, maxTicks);
    return all.length < needed ? null : all;
  };

  return {
    get ticks() {
      return ticks;
    },
    play(holds, within = maxTicks) {
      const joined = joinHolds(holds);
      const minerals = mineralsOf(joined, Math.min(within, maxTicks));
      const ending = simulation.ending;
      if (minerals === null || ending === null) return null;
      const { tick, time } = ending;
      // nothing is read after the last tick, so cutting there changes nothing
      return { holds: cutHolds(joined, tick), tick, time, minerals };
    },
  };
}

function countedMinerals(scene: Scene, holds: readonly Hold[], maxTicks: number): number[] {
  const { minerals } = simulate(scene, holds, { maxTime: maxTicks / TICK_RATE });
  return [...new Set(minerals.map(({ index }) => index))].sort((a, b) => a - b);
}

/**
 * The one judge of runs: replays a script from the start, at the scene's accuracy. Every run the solver reports has passed it.
 * @param maxTicks how long the run may last
 * @returns null when it does not reach the black hole with the minerals the goal asks for
 */
export function verifyRun(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal = { minerals: 'any' },
  maxTicks: number = DEFAULT_MAX_TICKS,
): Candidate | null {
  return createReplay(scene, goal, maxTicks).play(holds);
}
