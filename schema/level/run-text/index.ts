export { formatRunText } from './format-run-text.ts';
export { type ReadRunTextOptions, readRunText } from './read-run-text.ts';
export type { RunScript, RunTextPlace, RunTextReading, RunTextRemark } from './run-script.ts';
