export { addRuns, DEFAULT_NAME, freeName } from './add-runs.ts';
export { progressText } from './progress-text.ts';
export { type AskedRuns, askedRuns, type SolveSettings, settingsFor } from './settings.ts';
export { replayRuns, type Solved, type SolvedRun, solveHere, solveLevel } from './solve-level.ts';
export { solveReport } from './solve-report.ts';
