/** How everything that moves stands at one moment of a run; places in px. */
export interface Pose {
  readonly x: number;
  readonly y: number;
  /** Direction of her box's x axis, a unit vector. */
  readonly cos: number;
  readonly sin: number;
  /** Where the gun pulls; null while it is not held or there is nothing to pull at. */
  readonly beamTo: { readonly x: number; readonly y: number } | null;
  /** x, y, alive (1 or 0) of every alien; null: as the level has them */
  readonly aliens: Float64Array | null;
  /** x, y of every asteroid; null: as the level has them */
  readonly asteroids: Float64Array | null;
  /** Indices of the minerals that are taken. */
  readonly collected: ReadonlySet<number>;
}
