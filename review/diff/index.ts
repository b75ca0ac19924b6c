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
export { changesInWords, compareHolds, type HoldsChange, type MovedEdge } from './words/index.ts';
