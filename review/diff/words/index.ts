export { changesInWords } from './change-words.ts';
export { effectsInWords, standingInWords } from './effect-words.ts';
export { compareHolds, type HoldsChange, type MovedEdge } from './holds.ts';
export { keyInWords } from './values.ts';
