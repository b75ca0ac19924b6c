export { carryNotes, commonEnds, compareHolds, firstDifference } from './compare-holds.ts';
export {
  APART,
  AWAY,
  type Better,
  type ComparableRun,
  type Comparison,
  compareRuns,
  decidedInWords,
  type HoldPair,
  type Partings,
  pairInWords,
  partingsInWords,
  type RunsDifference,
  TOGETHER,
  type WaysApart,
  waysApart,
  waysInWords,
} from './compare-runs.ts';
