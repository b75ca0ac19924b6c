export { closestInWords, effortInWords } from './effort.ts';
export { holdsInWords } from './holds.ts';
export { plural } from './plural.ts';
export { showFileProblems } from './problem.ts';
export { problemJson } from './problem-json.ts';
export { percent, robustnessJson, robustnessLines } from './robustness.ts';
export { alignColumns } from './table.ts';
