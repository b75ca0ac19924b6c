export { byHolds, closestRunInWords } from './closest.ts';
export { inPieces, jsonWithLevels } from './pieces.ts';
export { showFileProblems } from './problem.ts';
export { problemJson } from './problem-json.ts';
export { percent, robustnessJson, robustnessLines } from './robustness.ts';
export { alignColumns } from './table.ts';
