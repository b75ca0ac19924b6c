import { compile } from '../../../engine/index.ts';
import { createSolver, type SolveOptions, type Solver } from '../../../solver/index.ts';
import type { Solving } from '../protocol.ts';
import { createPacer, type Start } from '../work.ts';

/** ms between two reports of a search that has found nothing new */
const TELL = 250;

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
  let reported = start - TELL;
  let best = solver.best;
  while (!solver.finished && (budget === null || now() - start < budget)) {
    pace((ticks) => solver.advance(ticks));
    const isNews = solver.best !== best || now() - reported >= TELL;
    if (isNews) reported = now();
    best = solver.best;
    yield isNews ? toSolving(solver) : null;
  }
  return toSolving(solver);
}

/** Searches for runs. */
export const solve: Start<'solve'> = ({ level, terms, budget, ...options }, now) =>
  search(createSolver(compile(level, terms), options satisfies SolveOptions), budget, now);
