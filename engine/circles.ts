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
