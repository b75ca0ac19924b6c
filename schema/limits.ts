/** What numbers and lists of a level may be at most, and radii at least. */
export const LIMITS = {
  /** px, either sign */
  coordinate: 1e9,
  /** px */
  radius: 1e6,
  /** px, radii and the range: recoil goes with 1 / diameter, and what is smaller could only be hit by rounding */
  leastRadius: 1e-3,
  /** px/s per axis, either sign: the game's own speed limit */
  velocity: 1000,
  /** ticks of 1/60 s: an hour */
  tick: 216_000,
  /** objects in one list */
  objects: 20_000,
  runs: 1000,
  /** holds in one run */
  holds: 20_000,
} as const;
