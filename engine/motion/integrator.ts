import type { Flow } from './flow.ts';

/** Many whole steps in a row; see {@link Integrator.glide}. `count[0]` grows by the number of steps made. */
export type Glide = (
  flow: Flow,
  x: Float64Array,
  y: Float64Array,
  start: number,
  end: number,
  rate: number,
  count: Int32Array,
) => number;

/**
 * A method that turns a flow into polynomial pieces. On entry, the first two coefficients of each series hold place and
 * velocity. Lengths are in s and px.
 */
export interface Integrator {
  readonly degree: number;
  /** Force evaluations per piece, for the account of work. */
  readonly evaluations: number;
  /** Whether a step accelerates her before it moves her, so that she gets farther than with the velocity that she has. */
  readonly kicksFirst: boolean;
  /**
   * Expands the astronaut's motion, and that of the frame's base where recoil moves it.
   * @param longest - the longest piece wanted, s; Infinity if there is no bound
   * @returns the length for which the piece holds, s
   */
  expand(
    flow: Flow,
    x: Float64Array,
    y: Float64Array,
    longest: number,
    px: Float64Array | null,
    py: Float64Array | null,
    kappa: number,
  ): number;
  /**
   * Expands a body that accelerates at `kappa` px/s² towards the place (ax, ay).
   * @returns the length for which it holds, s
   */
  chase(qx: Float64Array, qy: Float64Array, ax: Float64Array, ay: Float64Array, kappa: number, h: number): number;
  /** Upper bound of |u''| over the piece, px/s². */
  acceleration(flow: Flow, x: Float64Array, y: Float64Array, h: number): number;
  /** Writes place and velocity after `t` of an expanded piece to out[0..3]; null if the polynomial itself gives both. */
  readonly settle: ((flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array) => void) | null;
  /**
   * Makes whole steps of the grid of `rate` from `start` for as long as they end by `end` and begin outside the centre, see
   * {@link isInCentre}. Place and velocity in x[0..1],
   * y[0..1] get the bits that `expand` and `settle` would give, but no pieces are made. null for integrators without fixed
   * steps.
   * @returns the time reached, s
   */
  readonly glide: Glide | null;
}
