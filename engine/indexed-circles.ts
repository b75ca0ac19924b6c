import type { Disc } from '../schema/basics/index.ts';
import type { Circles } from './circles.ts';
import type { Indexing, SpatialIndex } from './spatial-index.ts';

/** A list of circles as they are placed in the level, with an index where there are many. */
export interface IndexedCircles extends Circles {
  /** The index; null for a list that is too short to be worth one. */
  readonly spatial: SpatialIndex | null;
}

/** Adds an index to a list of circles where it is worth one. */
export function indexed(circles: Circles, indexing: Indexing): IndexedCircles {
  const { count, x, y, r, index } = circles;
  // written out: a spread would give every list a hidden class of its own, which slows property access down in V8
  return { count, x, y, r, index, spatial: indexing.circles(circles) };
}

/** The circles of a list at the indices in `order`, as parallel arrays. */
export function circlesOf(list: readonly Disc[], order: readonly number[]): Circles {
  const pick = (f: (c: Disc) => number) => Float64Array.from(order, (i) => f(list[i]));
  return {
    count: order.length,
    x: pick((c) => c.x),
    y: pick((c) => c.y),
    r: pick((c) => c.radius),
    index: Int32Array.from(order),
  };
}
