import { HEAD_ON } from '../tolerances.ts';

/** No force: a straight line. */
export const COAST = 0;
/** A force towards or away from the centre of the frame, and a steady force w: u'' = alpha u / |u| + beta u + w. */
export const CENTRAL = 1;
/** The same on a line through the centre, where the direction is constant: u'' = a + beta (u - u0). */
export const LINEAR = 2;
/** Sliding along the rim of a field; see `Sliding`. */
export const SLIDE = 3;

/** A steady force alone: u'' = w. */
export const STEADY = 4;

/** Whether she falls through the centre of the force; see {@link HEAD_ON}. */
export const isInCentre = ({ kind }: Flow, x: Float64Array, y: Float64Array): boolean =>
  kind === CENTRAL && x[0] * x[0] + y[0] * y[0] < HEAD_ON * HEAD_ON;

/** The smooth motion between two events, in a frame whose origin is the centre of the force. */
export class Flow {
  kind = COAST;
  /** Acceleration along u / |u|, px/s²; negative for a pull. */
  alpha = 0;
  /** Acceleration per distance along u, 1/s². */
  beta = 0;
  /** LINEAR: the pull at the centre, px/s². */
  pull = 0;
  /**
   * LINEAR: the range of the pull (px; 0 for a push), the steady force along the line (px/s²), and the direction away from the
   * centre.
   */
  range = 0;
  extra = 0;
  outX = 0;
  outY = 0;
  /** LINEAR: how the line lies; see `line.ts`. */
  steep = false;
  slope = 0;
  /** LINEAR: acceleration and place at the start of the step. */
  ax = 0;
  ay = 0;
  x0 = 0;
  y0 = 0;
  /** The steady force that acts in addition, px/s²; whether there is any; and its strength. Set by {@link setSteady}. */
  steadyX = 0;
  steadyY = 0;
  isSteady = false;
  steadyStrength = 0;
  /** False while the speed limit holds this axis. */
  freeX = true;
  freeY = true;

  setSteady(x: number, y: number): void {
    this.steadyX = x;
    this.steadyY = y;
    this.isSteady = x !== 0 || y !== 0;
    this.steadyStrength = Math.sqrt(x * x + y * y);
  }

  /** LINEAR: begins a step at (x, y). */
  moveTo(x: number, y: number): void {
    // written such that the pull is exactly 0 at the range
    const pull = this.range > 0 ? this.pull * (1 - Math.sqrt(x * x + y * y) / this.range) : 0;
    this.ax = (this.extra - pull) * this.outX;
    this.ay = (this.extra - pull) * this.outY;
    if (this.isSteady) {
      this.ax += this.steadyX;
      this.ay += this.steadyY;
    }
    this.x0 = x;
    this.y0 = y;
  }

  /** Writes the acceleration at u = (x, y) to `out` from index `at` on. */
  accelerate(x: number, y: number, out: Float64Array, at: number): void {
    let ax = 0;
    let ay = 0;
    if (this.kind === CENTRAL) {
      const d = Math.sqrt(x * x + y * y);
      const f = (d > 0 ? this.alpha / d : 0) + this.beta;
      ax = f * x;
      ay = f * y;
      if (this.isSteady) {
        ax += this.steadyX;
        ay += this.steadyY;
      }
    } else if (this.kind === LINEAR) {
      ax = this.ax + this.beta * (x - this.x0);
      ay = this.ay + this.beta * (y - this.y0);
    } else if (this.kind === STEADY) {
      ax = this.steadyX;
      ay = this.steadyY;
    }
    out[at] = this.freeX ? ax : 0;
    out[at + 1] = this.freeY ? ay : 0;
  }
}

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
  /** Error of position that one piece may have, px; 0 with fixed steps, which do not control it. */
  readonly tolerance: number;
  /**
   * Expands a body that accelerates at `kappa` px/s² towards the place (ax, ay), and returns the length for which it holds, s.
   * null if its power series does; see `chaserSeries`.
   * @param recoils - whether it is the target, and no chaser
   */
  readonly chase:
    | ((
        qx: Float64Array,
        qy: Float64Array,
        ax: Float64Array,
        ay: Float64Array,
        kappa: number,
        h: number,
        recoils: boolean,
      ) => number)
    | null;
  /** Upper bound of |u''| over the piece, px/s². */
  acceleration(flow: Flow, x: Float64Array, y: Float64Array, h: number): number;
  /** Writes place and velocity after `t` of an expanded piece to out[0..3]; null if the polynomial itself gives both. */
  readonly arrive: ((flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array) => void) | null;
  /**
   * Makes whole steps of the grid of `rate` from `start` for as long as they end by `end` and begin outside the centre, see
   * {@link isInCentre}. Place and velocity in x[0..1],
   * y[0..1] get the bits that `expand` and `arrive` would give, but no pieces are made. null for integrators without fixed
   * steps.
   * @returns the time reached, s
   */
  readonly glide: Glide | null;
}
