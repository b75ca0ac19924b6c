/** Circles as parallel arrays, px. `index` is the place in the level's own list of that kind. */
export interface Circles {
  readonly count: number;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly r: Float64Array;
  readonly index: Int32Array;
}
