export { changedEntries } from './changed-entries.ts';
export { type Compared, type LockComparison, openComparison } from './comparison.ts';
