import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { createTrials, type Trials } from '../robustness/index.ts';
import { HeatMap } from '../search/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import { Restarts } from './restarts.ts';
import type { Objective, Solution } from './solution.ts';

/** What the ways of solving share: what is asked, what has been spent, what has been found. */
export interface SolverSession {
  readonly scene: Scene;
  readonly goal: Goal;
  readonly maxTicks: number;
  readonly objective: Objective;
  readonly count: number;
  /** Runs to start from, as they were given. */
  readonly known: readonly (readonly Hold[])[];
  /** A seed of its own for the n-th piece of work that needs one, n from 0 to 999,999. */
  seedOf(n: number): number;
  readonly trials: Trials;
  readonly restarts: Restarts;
  /** Where clouds of executions came by. */
  readonly cloudHeat: HeatMap;
  /** Best first. */
  solutions: readonly Solution[];
}

/** What is asked of a {@link SolverSession}. */
export interface SolverTask {
  readonly goal: Goal;
  readonly seed: number;
  readonly lane: number;
  readonly maxTicks: number;
  readonly objective: Objective;
  readonly count: number;
  readonly known: readonly (readonly Hold[])[];
}

/** Seeds of one lane; lanes have nothing in common up to so many. */
const SEEDS_OF_A_LANE = 1_000_000;
const SEEDS_OF_A_SOLVER = 1000 * SEEDS_OF_A_LANE;

/** 2^21: a whole number up to 2^53 is so many of these, less than 2^32, and a rest. */
const LOW = 2_097_152;

/** `seed * SEEDS_OF_A_SOLVER + lane * SEEDS_OF_A_LANE + n` modulo 2^53, exactly: rounded it would be the same for many n. */
function seedsOf(seed: number, lane: number): (n: number) => number {
  const high = Math.floor(seed / LOW);
  const low = (seed - high * LOW) * SEEDS_OF_A_SOLVER + lane * SEEDS_OF_A_LANE;
  return (n) => {
    const carry = Math.floor((low + n) / LOW);
    return ((Math.imul(high, SEEDS_OF_A_SOLVER) + carry) >>> 0) * LOW + (low + n - carry * LOW);
  };
}

export function createSolverSession(scene: Scene, task: SolverTask): SolverSession {
  const { goal, maxTicks, seed, lane } = task;
  const seedOf = seedsOf(seed, lane);
  return {
    scene,
    ...task,
    seedOf,
    trials: createTrials(scene, goal, maxTicks),
    cloudHeat: new HeatMap(scene.level.astronaut.x, scene.level.astronaut.y),
    restarts: new Restarts(scene, goal, maxTicks, seedOf),
    solutions: [],
  };
}

/** Ticks that a last hold which lasts to the end goes on after it. */
const HOLD_ON = 120;

/**
 * The run as a player would do it: without what comes after the end, and holding on where she arrives held.
 * @returns null when the run doesn't meet the goal
 */
export function playable(session: SolverSession, holds: readonly Hold[]): { verified: Candidate; holds: Hold[] } | null {
  const verified = verifyRun(session.scene, holds, session.goal, session.maxTicks);
  session.trials.runs++;
  session.trials.ticks += verified?.tick ?? session.maxTicks;
  if (verified === null) return null;
  const kept = joinHolds(holds).filter(([press]) => press <= verified.tick);
  const last = kept.length - 1;
  if (last >= 0 && kept[last][1] > verified.tick) kept[last] = [kept[last][0], verified.tick + HOLD_ON];
  return { verified, holds: kept };
}
