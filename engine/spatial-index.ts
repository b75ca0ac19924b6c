import type { Circles } from './circles.ts';

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
