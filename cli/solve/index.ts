export { addRuns, DEFAULT_NAME, freeName } from './add-runs.ts';
export { progressText } from './rounds.ts';
export { type AskedRuns, askedRuns, type SolveSettings, settingsFor } from './settings.ts';
export { replayRuns, type Solved, type SolvedRun, solveHere, solveLevel, solveReport } from './solve-level.ts';
