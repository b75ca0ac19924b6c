export { type MergedFile, mergeFiles } from './merge-files.ts';
export { mergeText, type TextMerge } from './merge-text.ts';
export { type ProofAgain, playAgain } from './proof-again.ts';
