export { type Cleaned, type CleanOptions, cleanRun } from './clean-run.ts';
export { mergeSolutions } from './merge-solutions.ts';
export type { Objective, Solution } from './solution.ts';
export { createSolver, type SolveOptions, type Solver } from './solver.ts';
