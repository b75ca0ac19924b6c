import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createRandom } from '../../random.ts';
import { advancing } from '../../steps.ts';
import type { Goal } from '../../verified-run.ts';
import { type Closest, type Effort, type Explored, HeatTally } from '../explore/index.ts';
import { changeRun } from './local-search.ts';
import { compareSolutions, mergeSolutions, type Objective, type Solution } from './solution.ts';
import { RobustWork } from './solve-robust.ts';
import { createSolverSession, playable, type SolverSession } from './solver-session.ts';

/** What {@link createSolver} looks for. */
export interface SolveOptions {
  /** What a run has to achieve; by default only the black hole. */
  readonly goal?: Goal;
  /** Seed of the random choices, a whole number; 0 by default. */
  readonly seed?: number;
  /**
   * Number of this solver among several that share the work, 0 to 999; 0 by default. Solvers with the same seed and different
   * lanes use independent random numbers. If a fixed number of lanes runs for a fixed effort each, and {@link mergeSolutions}
   * merges their solutions, the result does not depend on the number of workers.
   */
  readonly lane?: number;
  /** The longest a run may last, ticks; that of the scene by default. */
  readonly maxTicks?: number;
  /** What makes a run good; `robust` by default. */
  readonly objective?: Objective;
  /** How many different solutions to return at most; 1 by default. */
  readonly count?: number;
  /** Runs to start from, each [press, release) in ticks. Those that miss the goal are skipped. */
  readonly known?: readonly (readonly Hold[])[];
}

/** A search for good runs. It can be stopped at any time, and has its best solution so far. */
export interface Solver {
  /** The work done so far. */
  readonly effort: Effort;
  /** The closest approach so far; null until something has been simulated. */
  readonly closest: Closest | null;
  /** Where all searches have been so far. */
  readonly explored: Explored;
  /** The best solution so far; null if there is none. */
  readonly best: Solution | null;
  /**
   * The best solutions so far, best first: at most `count`, no two of them nearly the same. A replay from the start has
   * confirmed each of them.
   */
  readonly solutions: readonly Solution[];
  /** True when nothing can get better, or nothing can be found. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; the solver may overshoot a little
   */
  advance(ticks: number): void;
}

/**
 * Creates a solver for a scene. It simulates nothing before the first call of `advance`.
 * @param scene the compiled level
 * @param options the goal, the objective, the seed and the number of solutions
 * @returns a solver at its start
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createSolver } from 'gravity-quest-toolkit/solver';
 *
 * const solver = createSolver(compile(level), { objective: 'robust' });
 * while (!solver.finished && solver.effort.ticks < 5_000_000) solver.advance(50_000);
 * if (solver.best !== null) console.log(solver.best.holds, solver.best.p40?.p);
 * ```
 */
export function createSolver(scene: Scene, options: SolveOptions = {}): Solver {
  const { seed = 0, lane = 0, objective = 'robust', count = 1, known = [] } = options;
  const { goal = { minerals: 'any' }, maxTicks = maxTicksOf(scene.terms) } = options;
  const session = createSolverSession(scene, { goal, seed, lane, maxTicks, objective, count, known });
  const work = objective === 'robust' ? new RobustWork(session).run() : solvePlain(session);
  const spent = () => session.trials.ticks + session.restarts.effort.ticks;
  const going = advancing(work, spent);
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
      return going.finished;
    },
    advance: going.advance,
  };
}

/** Variations tried on a run before the next one is sought. */
const CHANGES = 60;

/**
 * Solves for the objectives `presses`, `time` and `first`, beginning with the known runs. Yields between small pieces of work.
 */
function* solvePlain(session: SolverSession): Generator<void, void> {
  const { restarts, objective, count } = session;
  const random = createRandom(session.seedOf(0));
  const known = [...session.known];
  while (known.length > 0 || !restarts.exhausted) {
    const given = known.shift();
    const run = given === undefined ? restarts.next() : (playable(session, given)?.verified ?? null);
    yield;
    if (run === null) continue;
    let best = toSolution(session, run);
    session.solutions = mergeSolutions([session.solutions, [best]], { count });
    if (objective !== 'first') {
      for (let i = 0; i < CHANGES && best.holds.length > 0; i++) {
        const changed = tried(session, changeRun(best.holds, random));
        if (changed !== null && compareSolutions(changed, best) < 0) best = changed;
        yield;
      }
      session.solutions = mergeSolutions([session.solutions, [best]], { count });
    }
    if (isFinal(session)) return;
  }
}

function tried(session: SolverSession, holds: readonly Hold[]): Solution | null {
  const run = playable(session, holds);
  return run === null ? null : toSolution(session, run.verified);
}

function toSolution({ objective }: SolverSession, candidate: Omit<Solution, 'score' | 'p40' | 'certified'>): Solution {
  const score = objective === 'time' ? -candidate.time : objective === 'presses' ? -candidate.holds.length : 0;
  return { ...candidate, score, p40: null, certified: false };
}

/** Whether nothing can get better: there are enough runs under `first`, or a run without a press under `presses`. */
function isFinal({ objective, solutions, count }: SolverSession): boolean {
  if (objective === 'first') return solutions.length >= count;
  return objective === 'presses' && count === 1 && solutions.length === 1 && solutions[0].holds.length === 0;
}
