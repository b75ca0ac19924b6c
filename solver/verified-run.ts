import { createSimulation, joinHolds, maxTicksOf, playScript, type Scene, simulate, TICK_RATE } from '../engine/index.ts';
import type { Hold } from '../schema/basics/index.ts';

/** A run that meets its goal, confirmed by a replay from the start. */
export interface Candidate {
  /** The holds as [press, release) in ticks: sorted, disjoint, and cut off at the end of the run. */
  readonly holds: readonly Hold[];
  /** The tick in which she reaches the black hole. */
  readonly tick: number;
  /** The time at which she reaches the black hole, s from the start. */
  readonly time: number;
  /** Indices of the different minerals collected on the way, from 0 in the level's list, ascending. */
  readonly minerals: readonly number[];
}

/** Replays many runs of one scene, one after the other. It judges as {@link verifyRun} does. */
export interface Replay {
  /** Ticks simulated so far. */
  readonly ticks: number;
  /**
   * Replays one run from the start.
   * @param holds [press, release) in ticks; they are sorted and joined where they overlap
   * @param within the run must end within this many ticks; it has no effect above the limit given to {@link createReplay}
   * @returns the run, or null when it does not meet the goal in time
   */
  play(holds: readonly Hold[], within?: number): Candidate | null;
}

/**
 * Removes the part of a run that comes after its end.
 * @param holds [press, release) in ticks, sorted and disjoint
 * @param tick the tick in which the run ends
 * @returns the holds up to and including that tick
 */
export function cutHolds(holds: readonly Hold[], tick: number): Hold[] {
  return holds.filter(([press]) => press <= tick).map(([press, release]) => [press, Math.min(release, tick + 1)]);
}

/**
 * Creates a judge for many runs of one scene. It simulates as `simulate` does, bit for bit, but records nothing, which makes it
 * several times as fast.
 * @param scene the compiled level
 * @param goal what a run has to achieve
 * @param maxTicks the longest a run may last, ticks
 * @returns a judge that has not simulated anything yet
 */
export function createReplay(scene: Scene, goal: Goal, maxTicks: number = maxTicksOf(scene.terms)): Replay {
  const simulation = createSimulation(scene);
  const needed = mineralsNeeded(goal, scene.minerals.count);
  let ticks = 0;

  /** Plays a run to its end. Returns the indices of its minerals, or null when it misses the goal. */
  const mineralsOf = (holds: readonly Hold[], within: number): number[] | null => {
    simulation.reset();
    playScript(simulation, holds, within);
    ticks += simulation.tick;
    if (simulation.ending?.outcome !== 'completed') return null;
    const minerals: number[] = [];
    for (let i = 0; i < scene.minerals.count; i++) if (simulation.isCollected(i)) minerals.push(i);
    // When several minerals are touched in one frame, `arcade` counts all of them but removes only one. Only the recorded
    // events say which minerals she has.
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
      // The game reads no button after the last tick, so the cut changes nothing.
      return { holds: cutHolds(joined, tick), tick, time, minerals };
    },
  };
}

function countedMinerals(scene: Scene, holds: readonly Hold[], maxTicks: number): number[] {
  const { minerals } = simulate(scene, holds, { maxTime: maxTicks / TICK_RATE });
  return [...new Set(minerals.map(({ index }) => index))].sort((a, b) => a - b);
}

/**
 * Decides whether a run meets a goal: it replays the run from the start at the scene's accuracy. Every run that the solver
 * reports has passed this function.
 * @param scene the compiled level
 * @param holds [press, release) in ticks; they are sorted and joined where they overlap
 * @param goal what the run has to achieve; by default only the black hole
 * @param maxTicks the longest the run may last, ticks
 * @returns the run, or null when it does not reach the black hole in time with the minerals that the goal requires
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { verifyRun } from 'gravity-quest-toolkit/solver';
 *
 * const run = verifyRun(compile(level), [[12, 96]], { minerals: 'all' });
 * console.log(run === null ? 'misses the goal' : `completed after ${run.time} s`);
 * ```
 */
export function verifyRun(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal = { minerals: 'any' },
  maxTicks: number = maxTicksOf(scene.terms),
): Candidate | null {
  return createReplay(scene, goal, maxTicks).play(holds);
}

/** What a run has to achieve besides reaching the black hole. */
export interface Goal {
  /**
   * How many different minerals the run must collect: `any` requires none, `all` requires every one in the level, a whole
   * number requires at least that many.
   */
  readonly minerals: 'any' | 'all' | number;
}

/**
 * Converts a goal into a number of minerals.
 * @param goal what a run has to achieve
 * @param count the number of minerals in the level
 * @returns how many different minerals a run must collect; this may exceed `count`
 */
export function mineralsNeeded(goal: Goal, count: number): number {
  if (goal.minerals === 'any') return 0;
  return goal.minerals === 'all' ? count : goal.minerals;
}

/** Converts edges, the ticks at which the button changes, back into holds; null where the edges are not strictly ascending, or one is negative. */
export function holdsOf(edges: readonly number[]): Hold[] | null {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) {
    if (edges[i] < 0 || edges[i + 1] <= edges[i] || (i > 0 && edges[i] <= edges[i - 1])) return null;
    holds.push([edges[i], edges[i + 1]]);
  }
  return holds;
}
