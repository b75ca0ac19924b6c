import type { Disc } from '../schema/basics/index.ts';
import type { Circles } from './circles.ts';
import type { Indexing, SpatialIndex } from './spatial-index.ts';

/** A list of circles as they are placed in the level, with an index where there are many. */
export interface IndexedCircles extends Circles {
  /** The index; null for a list that is too short to be worth one. */
  readonly spatial: SpatialIndex | null;
}

const NO_NUMBERS = new Float64Array(0);

const NO_CIRCLES: Circles = { count: 0, x: NO_NUMBERS, y: NO_NUMBERS, r: NO_NUMBERS, index: new Int32Array(0) };

/** Adds an index to a list of circles where it is worth one. */
export function indexed(circles: Circles, indexing: Indexing): IndexedCircles {
  const { count, x, y, r, index } = circles;
  // written out: a spread would give every list a hidden class of its own, which slows property access down in V8
  return { count, x, y, r, index, spatial: indexing.circles(circles) };
}

/**
 * The circles of a list as parallel arrays.
 * @param order - the indices of those that are taken, in their order; all of the list when left out
 */
export function circlesOf(list: readonly Disc[], order?: readonly number[]): Circles {
  const count = order === undefined ? list.length : order.length;
  // most lists of most levels are empty
  if (count === 0) return NO_CIRCLES;
  const x = new Float64Array(count);
  const y = new Float64Array(count);
  const r = new Float64Array(count);
  const index = new Int32Array(count);
  for (let k = 0; k < count; k++) {
    const i = order === undefined ? k : order[k];
    const disc = list[i];
    x[k] = disc.x;
    y[k] = disc.y;
    r[k] = disc.radius;
    index[k] = i;
  }
  return { count, x, y, r, index };
}
