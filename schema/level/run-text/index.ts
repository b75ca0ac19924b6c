export { type ReadRunTextOptions, readRunText } from './read-run-text.ts';
export { formatRunText, type RunScript, type RunTextPlace, type RunTextReading, type RunTextRemark } from './run-script.ts';
