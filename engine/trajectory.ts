/** Where she was at every moment of a run. */
export interface Trajectory {
  /** s */
  readonly duration: number;
  /** Writes x, y (px), vx, vy (px/s), cos, sin of the box's x axis at `time` (s, clamped to the run) into `out`. */
  at(time: number, out: Float64Array): void;
  /** Writes x, y (px), alive (1 or 0) of every alien at `time` into `out`, 3 doubles each. */
  aliensAt(time: number, out: Float64Array): void;
  /** Writes x, y (px) of every asteroid, in the level's order, at `time` into `out`, 2 doubles each: recoil moves them. */
  asteroidsAt(time: number, out: Float64Array): void;
}
