/** The motion of a run, to be read at any time from its start to its end. */
export interface Trajectory {
  /** Length of the run, s. */
  readonly duration: number;
  /**
   * Writes the state of the astronaut at a time: x, y (px), vx, vy (px/s), cos, sin of the angle of the collision box's x axis.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 6 doubles ({@link STATE_SIZE})
   */
  at(time: number, out: Float64Array): void;
  /**
   * Writes x, y (px) and alive (1, or 0 once exploded) of every alien at a time, in the level's order.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 3 doubles per alien
   */
  aliensAt(time: number, out: Float64Array): void;
  /**
   * Writes x, y (px) of every asteroid at a time, in the level's order. Recoil moves asteroids.
   *
   * @param time - s from the start; clamped to the run
   * @param out - receives 2 doubles per asteroid
   */
  asteroidsAt(time: number, out: Float64Array): void;
}
