export { type Compared, type LockComparison, openComparison } from './comparison.ts';
