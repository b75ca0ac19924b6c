import type { Flow } from './flow.ts';

/** Many whole steps in a row, see {@link Integrator.glide}; `count[0]` grows by the steps made. */
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
 * A way to turn a flow into polynomial pieces. Series hold place and velocity in [0..1] on entry; lengths in s, px.
 */
export interface Integrator {
  readonly degree: number;
  /** Force evaluations a piece costs, for the account of work. */
  readonly evaluations: number;
  /**
   * Expands the astronaut's motion, and the recoiling base's where there is one.
   * @param longest how far the piece may reach; Infinity when nothing says
   * @returns the length for which the piece holds
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
  /** Expands a body that accelerates at `kappa` towards the place (ax, ay); returns the length for which it holds. */
  chase(qx: Float64Array, qy: Float64Array, ax: Float64Array, ay: Float64Array, kappa: number, h: number): number;
  /** Bound on |u''| over the piece. */
  acceleration(flow: Flow, x: Float64Array, y: Float64Array, h: number): number;
  /** Place and velocity after `t` of an expanded piece, into out[0..3]; null where the piece itself says both. */
  readonly settle: ((flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array) => void) | null;
  /**
   * Makes whole steps of the grid of `rate` from `start` while they end by `end`: place and velocity in x[0..1], y[0..1]
   * become the bits that `expand` and `settle` would give, without the pieces. null where there are no fixed steps.
   * @returns the time reached
   */
  readonly glide: Glide | null;
}
