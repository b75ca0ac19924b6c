export { type Cleaned, type CleanOptions, cleanRun } from './clean-run.ts';
export { mergeSolutions, type Objective, type Solution } from './solution.ts';
export { createSolver, type SolveOptions, type Solver } from './solver.ts';
