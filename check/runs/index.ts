export { carryNotes } from './carry-notes.ts';
export { compareHolds, type HoldsChange, type MovedEdge } from './compare-holds.ts';
export { firstDifference } from './first-difference.ts';
