import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import {
  type Closest,
  createSolver,
  type Effort,
  type Explored,
  type Goal,
  type Objective,
  type Solution,
  type SolveOptions,
  type Solver,
} from '../../../solver/index.ts';
import { createPacer, createReporting, job, type Played, type Work } from '../job.ts';

/** How far a search has come. */
export interface Solving {
  readonly effort: Effort;
  readonly closest: Closest | null;
  /** best first */
  readonly solutions: readonly Solution[];
  readonly explored: Explored;
  readonly finished: boolean;
}

/** Searches for runs within a budget, ms; null: until cancelled or nothing can improve. */
export const solve = job<
  Played & {
    readonly goal: Goal;
    readonly objective: Objective;
    readonly count: number;
    /** Runs to start from; those that don't meet the goal are skipped. */
    readonly known: readonly (readonly Hold[])[];
    readonly seed: number;
    readonly lane: number;
    readonly budget: number | null;
  },
  Solving,
  Solving
>({ name: 'solve', lane: 'long', most: null });

/** ms between two reports of a search that has found nothing new */
const REPORT = 250;

const toSolving = ({ effort, closest, solutions, explored, finished }: Solver): Solving => ({
  effort: { ...effort },
  closest,
  solutions: [...solutions],
  explored,
  finished,
});

/** Searches for a limited time and reports every better run at once. */
export function* search(solver: Solver, budget: number | null, now: () => number): Generator<Solving | null, Solving, void> {
  const start = now();
  const pace = createPacer(now);
  const isReportDue = createReporting(REPORT, start, now);
  // nothing is reported yet
  let best: Solver['best'] | undefined;
  while (!solver.finished && (budget === null || now() - start < budget)) {
    pace((ticks) => solver.advance(ticks));
    const isNews = solver.best !== best;
    best = solver.best;
    yield isReportDue(isNews) ? toSolving(solver) : null;
  }
  return toSolving(solver);
}

/** Searches for runs. */
export const solveWork: Work<typeof solve> = {
  of: solve,
  steps: ({ level, terms, budget, ...options }, now) =>
    search(createSolver(compile(level, terms), options satisfies SolveOptions), budget, now),
};
