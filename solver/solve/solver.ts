import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { type Closest, type Effort, type Explored, HeatTally } from '../search/index.ts';
import { DEFAULT_MAX_TICKS } from '../verified-run.ts';
import type { Objective, Solution } from './solution.ts';
import { solvePlain } from './solve-plain.ts';
import { RobustWork } from './solve-robust.ts';
import { createSolverSession } from './solver-session.ts';

export interface SolveOptions {
  /** any minerals when left out */
  readonly goal?: Goal;
  /** a whole number; 0 when left out */
  readonly seed?: number;
  /**
   * Solvers of the same seed and different lanes look for themselves, with random numbers of their own: a fixed number of
   * lanes, each run for a fixed effort on however many workers, merged by `mergeSolutions`, give the same answer. 0 to 999.
   */
  readonly lane?: number;
  /** how long a run may last, ticks; a minute when left out */
  readonly maxTicks?: number;
  /** `robust` when left out */
  readonly objective?: Objective;
  /** different solutions wanted; 1 when left out */
  readonly count?: number;
  /** runs to start from; those that don't meet the goal are passed over */
  readonly known?: readonly (readonly Hold[])[];
}

/** A search for good runs, advanced bit by bit: it has its best so far at any time. */
export interface Solver {
  readonly effort: Effort;
  /** The nearest that any run came to the black hole; null until something has been simulated. */
  readonly closest: Closest | null;
  /** Where searches of all kinds have been so far. */
  readonly explored: Explored;
  readonly best: Solution | null;
  /** Best first, really different ones, at most `count`. Each has been verified by a replay from the start. */
  readonly solutions: readonly Solution[];
  /** Nothing can get better, or nothing can be found. */
  readonly finished: boolean;
  /** Simulates about so many ticks more. The same total gives the same result however it is split. */
  advance(ticks: number): void;
}

/** Solves a scene; nothing is simulated before the first `advance`. */
export function createSolver(scene: Scene, options: SolveOptions = {}): Solver {
  const { seed = 0, lane = 0, objective = 'robust', count = 1, known = [] } = options;
  const { goal = { minerals: 'any' }, maxTicks = DEFAULT_MAX_TICKS } = options;
  const session = createSolverSession(scene, { goal, seed, lane, maxTicks, objective, count, known });
  const work = objective === 'robust' ? new RobustWork(session).run() : solvePlain(session);
  let asked = 0;
  let finished = false;
  const spent = () => session.trials.ticks + session.restarts.effort.ticks;
  return {
    get effort() {
      return { runs: session.trials.runs + session.restarts.effort.runs, ticks: spent() };
    },
    get closest() {
      return session.restarts.closest;
    },
    get explored() {
      return new HeatTally().explored(session.restarts.explored, session.cloudHeat.explored());
    },
    get best() {
      return session.solutions[0] ?? null;
    },
    get solutions() {
      return session.solutions;
    },
    get finished() {
      return finished;
    },
    advance(ticks) {
      asked += ticks;
      while (!finished && spent() < asked) finished = work.next().done === true;
    },
  };
}
