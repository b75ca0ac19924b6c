import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createTrials, type Trials } from '../../measure/robustness/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../verified-run.ts';
import { type Closest, createSearch, type Effort, type Explored, HeatMap, HeatTally, type Search } from '../explore/index.ts';
import { cleanRun } from './clean-run.ts';
import type { Objective, Solution } from './solution.ts';

/** The state that all parts of a solver share: the task, the work done and the solutions. */
export interface SolverSession {
  readonly scene: Scene;
  readonly goal: Goal;
  readonly seed: number;
  readonly maxTicks: number;
  readonly objective: Objective;
  readonly count: number;
  /** Runs to start from, as given. */
  readonly known: readonly (readonly Hold[])[];
  /** A distinct seed for the n-th piece of work that needs one, n from 0 to 999,999. */
  seedOf(n: number): number;
  readonly trials: Trials;
  readonly restarts: Restarts;
  /** Where clouds of noisy attempts have been. */
  readonly cloudHeat: HeatMap;
  /** Best first. */
  solutions: readonly Solution[];
}

/** The task of a {@link SolverSession}. */
interface SolverTask {
  readonly goal: Goal;
  readonly seed: number;
  readonly lane: number;
  readonly maxTicks: number;
  readonly objective: Objective;
  readonly count: number;
  readonly known: readonly (readonly Hold[])[];
}

/** Seeds per lane. Lanes have no seed in common. */
const SEEDS_OF_A_LANE = 1_000_000;
const SEEDS_OF_A_SOLVER = 1000 * SEEDS_OF_A_LANE;

/** 2^21: a whole number up to 2^53 is a multiple of it, with a factor below 2^32, plus a remainder. */
const LOW = 2_097_152;

/**
 * Computes `seed * SEEDS_OF_A_SOLVER + lane * SEEDS_OF_A_LANE + n` modulo 2^53 exactly; rounding would give the same seed for
 * many n.
 */
function seedsOf(seed: number, lane: number): (n: number) => number {
  const high = Math.floor(seed / LOW);
  const low = (seed - high * LOW) * SEEDS_OF_A_SOLVER + lane * SEEDS_OF_A_LANE;
  return (n) => {
    const carry = Math.floor((low + n) / LOW);
    return ((Math.imul(high, SEEDS_OF_A_SOLVER) + carry) >>> 0) * LOW + (low + n - carry * LOW);
  };
}

/** Creates a session in which nothing has been simulated. */
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

/** How long a last hold that lasts to the end goes on after it, ticks. */
const HOLD_ON = 120;

/**
 * Converts a run into what a player would do: what comes after the end is cut off, and a button that is held at the end stays
 * held for a while.
 * @returns null when the run does not meet the goal
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

/** Ticks that a search simulates per call, so that the caller can stop between calls. */
const GO = 500;

/** A later search is abandoned after this many times the cost of the most expensive success, but not before `LEAST_TICKS`. */
const PATIENCE = 4;
const LEAST_TICKS = 100_000;

/** Produces simplified runs from searches that restart with new seeds, so that the runs are independent of each other. */
class Restarts {
  private readonly scene: Scene;
  private readonly goal: Goal;
  private readonly maxTicks: number;
  private readonly seedOf: (restart: number) => number;
  private readonly first: Search;
  private search: Search;
  private count = 0;
  private mostExpensive = 0;
  private readonly past = new HeatTally();
  private nearest: Closest | null = null;
  private runs = 0;
  private ticks = 0;

  constructor(scene: Scene, goal: Goal, maxTicks: number, seedOf: (restart: number) => number) {
    this.scene = scene;
    this.goal = goal;
    this.maxTicks = maxTicks;
    this.seedOf = seedOf;
    this.first = this.start();
    this.search = this.first;
  }

  get effort(): Effort {
    const { runs, ticks } = this.search.effort;
    return { runs: this.runs + runs, ticks: this.ticks + ticks };
  }

  /** The closest approach of all searches. */
  get closest(): Closest | null {
    const now = this.search.closest;
    return now === null || (this.nearest !== null && this.nearest.distance <= now.distance) ? this.nearest : now;
  }

  /** Where all searches have been. */
  get explored(): Explored {
    return this.past.explored(this.search.explored);
  }

  /** True when there is nothing to try, because the goal requires more minerals than the level has. */
  get exhausted(): boolean {
    return this.first.exhausted;
  }

  /**
   * Continues the search for a while.
   * @returns a run if one was found
   */
  next(): Candidate | null {
    const { search, scene, goal, maxTicks } = this;
    search.advance(GO);
    const found = search.solutions[0];
    if (found === undefined) {
      const limit = Math.max(LEAST_TICKS, PATIENCE * this.mostExpensive);
      if (this.mostExpensive > 0 && search.effort.ticks > limit) this.restart();
      return null;
    }
    this.mostExpensive = Math.max(this.mostExpensive, search.effort.ticks);
    this.restart();
    const cleaned = cleanRun(scene, found.holds, goal, { maxTicks });
    if (cleaned === null) return null;
    this.runs += cleaned.effort.runs;
    this.ticks += cleaned.effort.ticks;
    return cleaned.run;
  }

  private start(): Search {
    return createSearch(this.scene, { goal: this.goal, maxTicks: this.maxTicks, seed: this.seedOf(this.count++) });
  }

  private restart(): void {
    this.nearest = this.closest;
    this.past.add(this.search.explored);
    this.runs += this.search.effort.runs;
    this.ticks += this.search.effort.ticks;
    this.search = this.start();
  }
}
