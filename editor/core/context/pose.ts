/** The positions of everything that moves at one moment of a run, in px. */
export interface Pose {
  readonly x: number;
  readonly y: number;
  /** The direction of the box's x axis, a unit vector. */
  readonly cos: number;
  readonly sin: number;
  /** Where the gun pulls; null while it is not held or there is no target. */
  readonly beamTo: { readonly x: number; readonly y: number } | null;
  /** x, y, alive (1 or 0) of every alien; null: as in the level */
  readonly aliens: Float64Array | null;
  /** x, y of every asteroid; null: as in the level */
  readonly asteroids: Float64Array | null;
  /** Indices of the collected minerals. */
  readonly collected: ReadonlySet<number>;
}
