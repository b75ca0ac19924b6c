export { carryNotes } from './carry-notes.ts';
export { compareHolds } from './compare-holds.ts';
export {
  type Better,
  type ComparableRun,
  type Comparison,
  compareRuns,
  type HoldPair,
  type RunsDifference,
} from './compare-runs.ts';
export { pairInWords, partingsInWords } from './difference-words.ts';
export { APART, AWAY, distancesOf, type Partings, partingsOf, TOGETHER } from './distances.ts';
export { firstDifference } from './first-difference.ts';
