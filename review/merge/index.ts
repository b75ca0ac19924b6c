export type { Choices, Conflict, Side } from './conflict.ts';
export { conflictsOf, resolveConflicts, withConflicts } from './file-conflicts.ts';
export { type Merged, mergeLevels } from './merge-levels.ts';
export { shareIds } from './share-ids.ts';
