/** Limits of the numbers and lists in a level: largest values, and the smallest radius. */
export const LIMITS = {
  /** Coordinates, px, either sign. */
  coordinate: 1e9,
  /** Radii and the range, px. */
  radius: 1e6,
  /**
   * The smallest radius and range, px. Recoil is proportional to 1 / diameter, and only rounding could hit anything smaller.
   */
  leastRadius: 1e-3,
  /** Velocities, px/s per axis, either sign: the game's own speed limit. */
  velocity: 1000,
  /** Ticks of 1/60 s in holds: one hour. */
  tick: 216_000,
  /** Objects in one list. */
  objects: 20_000,
  /** Runs in one level. */
  runs: 1000,
  /** Holds in one run. */
  holds: 20_000,
  /** Notes in one run. */
  notes: 1000,
  /** Characters of a note. */
  note: 200,
  /** Conflicts that a merge may leave in one level. */
  conflicts: 20_000,
  /** Characters of the reason why a problem is allowed. */
  reason: 300,
} as const;
