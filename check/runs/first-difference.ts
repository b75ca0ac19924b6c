import type { Hold } from '../../schema/index.ts';

/** The first tick at which two scripts of holds differ; infinite if they are equal. Both must be sorted and disjoint. */
export function firstDifference(a: readonly Hold[], b: readonly Hold[]): number {
  for (let i = 0; i < Math.max(a.length, b.length); i++) {
    if (i >= a.length) return b[i][0];
    if (i >= b.length) return a[i][0];
    if (a[i][0] !== b[i][0]) return Math.min(a[i][0], b[i][0]);
    if (a[i][1] !== b[i][1]) return Math.min(a[i][1], b[i][1]);
  }
  return Number.POSITIVE_INFINITY;
}
