import type { Disc } from '../schema/basics/index.ts';

/** A list of circles as they are placed in the level, with an index where there are many. */
export interface IndexedCircles extends Circles {
  /** The index; null for a list that is too short to be worth one. */
  readonly spatial: SpatialIndex | null;
}

const NO_NUMBERS = new Float64Array(0);

/** No circles at all. */
export const NO_CIRCLES: IndexedCircles = {
  ...{ count: 0, x: NO_NUMBERS, y: NO_NUMBERS, r: NO_NUMBERS, index: new Int32Array(0) },
  spatial: null,
};

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

/** Circles as parallel arrays: entry i of each array belongs to circle i. */
export interface Circles {
  /** Number of circles, and the length of each array. */
  readonly count: number;
  /** x of each centre, px. */
  readonly x: Float64Array;
  /** y of each centre, px. */
  readonly y: Float64Array;
  /** Radii, px. */
  readonly r: Float64Array;
  /** Index of each circle within the level's own list of its kind, from 0. */
  readonly index: Int32Array;
}

/** Lists of at least this many circles get an index; for shorter ones, plain loops are faster. */
export const INDEX_FROM = 128;

/** Finds circles of one list near a place without examining all of them. Places are in px from the level's origin. */
export interface SpatialIndex {
  /**
   * Finds the circles that overlap a square.
   *
   * @param x - x of the square's centre, px
   * @param y - y of the square's centre, px
   * @param reach - half the side of the square, px
   * @returns indices of all such circles, in no particular order
   */
  around(x: number, y: number, reach: number): readonly number[];
  /**
   * Finds a circle whose centre is the nearest to a place.
   *
   * @param x - x of the place, px
   * @param y - y of the place, px
   * @returns index of one of the nearest
   */
  nearestCentre(x: number, y: number): number;
}

/** Makes indexes. */
export interface Indexing {
  /** Makes an index of a list; null if the list is too short to be worth one. */
  circles(circles: Circles): SpatialIndex | null;
  /**
   * Makes an index of boxes.
   * @param boxes - least x, least y, largest x, largest y of each, px
   * @returns a function that finds, in no particular order, those after the k-th that overlap it
   */
  boxes(boxes: Float64Array): (k: number) => number[];
}
