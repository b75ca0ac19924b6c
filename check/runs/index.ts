export { carryNotes, compareHolds, firstDifference } from './compare-holds.ts';
export {
  APART,
  AWAY,
  type Better,
  type ComparableRun,
  type Comparison,
  compareRuns,
  distancesOf,
  type HoldPair,
  type Partings,
  pairInWords,
  partingsInWords,
  partingsOf,
  type RunsDifference,
  TOGETHER,
} from './compare-runs.ts';
