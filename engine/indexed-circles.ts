import type { Disc } from '../schema/index.ts';
import type { Circles } from './circles.ts';
import { indexCircles, type SpatialIndex } from './spatial-index.ts';

/** A list of circles as the level has them, with an index where there are many. */
export interface IndexedCircles extends Circles {
  readonly spatial: SpatialIndex | null;
}

/** The same with an index where there are many. */
export function indexed(circles: Circles): IndexedCircles {
  const { count, x, y, r, index } = circles;
  // one by one: `...` would give every list a shape of its own, which V8 then has to search
  return { count, x, y, r, index, spatial: indexCircles(circles) };
}

/** Circles of a list as parallel arrays: those at the places of `order`. */
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
