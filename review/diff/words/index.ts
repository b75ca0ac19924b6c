export { changesInWords } from './change-words.ts';
export { compareHolds, type HoldsChange, type MovedEdge } from './holds.ts';
export { quoted } from './values.ts';
