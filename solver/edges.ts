import type { Hold } from '../schema/basics/index.ts';

/** The ticks at which the button changes, two for each hold. */
export const edgesOf = (holds: readonly Hold[]): number[] => holds.flat();

/** Converts edges back into holds; null where the edges are not strictly ascending, or one is negative. */
export function holdsOf(edges: readonly number[]): Hold[] | null {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) {
    if (edges[i] < 0 || edges[i + 1] <= edges[i] || (i > 0 && edges[i] <= edges[i - 1])) return null;
    holds.push([edges[i], edges[i + 1]]);
  }
  return holds;
}
