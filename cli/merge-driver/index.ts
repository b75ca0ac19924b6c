export { type MergedFile, mergeFiles } from './merge-files.ts';
export { mergeText } from './merge-text.ts';
export { playAgain } from './proof-again.ts';
