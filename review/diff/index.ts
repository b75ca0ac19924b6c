export { applyDiff } from './apply-diff.ts';
export type {
  Change,
  EmptyListChange,
  EntryChange,
  FieldChange,
  KeyOrder,
  LevelKeysChange,
  MapChange,
  MatchedBy,
  OrderChange,
  PartChange,
  ValueChange,
} from './change.ts';
export { diffLevels } from './diff-levels.ts';
export { levelInLines } from './level-lines.ts';
export {
  type AssessOptions,
  assessLevel,
  playAlike,
  renamedStanding,
  type Standing,
  type StandingRun,
} from './standing.ts';
export {
  changesInWords,
  compareHolds,
  effectsInWords,
  type HoldsChange,
  type MovedEdge,
  standingInWords,
} from './words/index.ts';
