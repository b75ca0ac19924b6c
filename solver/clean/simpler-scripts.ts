import type { Hold } from '../../schema/basics/index.ts';

/** Removes hold `i`. */
export const withoutHold = (holds: readonly Hold[], i: number): Hold[] => holds.filter((_, k) => k !== i);

/** Extends hold `i` to the end of the next one. */
export const joined = (holds: readonly Hold[], i: number): Hold[] => [
  ...holds.slice(0, i),
  [holds[i][0], holds[i + 1][1]],
  ...holds.slice(i + 2),
];

/** Moves edge `i` and all later ones earlier by this many ticks. */
export const earlierFrom = (edges: readonly number[], i: number, ticks: number): number[] =>
  edges.map((edge, k) => (k >= i ? edge - ticks : edge));

/** The multiple of `grid` nearest to a tick. */
export const rounded = (tick: number, grid: number): number => Math.round(tick / grid) * grid;
