export { addRuns, expectWritable } from './add-runs.ts';
export { progressText } from './progress-text.ts';
export type { SolveSettings } from './settings.ts';
export { type Solved, type SolvedRun, solveLevel } from './solve-level.ts';
