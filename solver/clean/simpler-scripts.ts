import type { Hold } from '../../schema/index.ts';

/** Without hold `i`. */
export const withoutHold = (holds: readonly Hold[], i: number): Hold[] => holds.filter((_, k) => k !== i);

/** Hold `i` goes on until the next one ends. */
export const joined = (holds: readonly Hold[], i: number): Hold[] => [
  ...holds.slice(0, i),
  [holds[i][0], holds[i + 1][1]],
  ...holds.slice(i + 2),
];

/** The ticks at which the button changes, two a hold. */
export const edgesOf = (holds: readonly Hold[]): number[] => holds.flat();

/** Holds from edges; null where an edge comes before the one before it, or a hold or pause would vanish. */
export function holdsOf(edges: readonly number[]): Hold[] | null {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) {
    if (edges[i] < 0 || edges[i + 1] <= edges[i] || (i > 0 && edges[i] <= edges[i - 1])) return null;
    holds.push([edges[i], edges[i + 1]]);
  }
  return holds;
}

/** Everything from edge `i` on comes `ticks` earlier. */
export const earlierFrom = (edges: readonly number[], i: number, ticks: number): number[] =>
  edges.map((edge, k) => (k >= i ? edge - ticks : edge));

/** The multiple of `grid` nearest to a tick. */
export const rounded = (tick: number, grid: number): number => Math.round(tick / grid) * grid;
