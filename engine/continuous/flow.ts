/** No force: a straight line. */
export const COAST = 0;
/** Towards or away from the centre of the frame: u'' = alpha u / |u| + beta u. */
export const CENTRAL = 1;
/** The same on a line through the centre, where the direction is constant: u'' = a + beta (u - u0). */
export const LINEAR = 2;

/** The smooth motion between two events, in a frame whose origin is the centre of the force. */
export class Flow {
  kind = COAST;
  /** px/s2 along u / |u|: negative pulls */
  alpha = 0;
  /** 1/s2 */
  beta = 0;
  /** LINEAR: acceleration and place at the start */
  ax = 0;
  ay = 0;
  x0 = 0;
  y0 = 0;
  /** false: the speed limit holds this axis */
  freeX = true;
  freeY = true;

  /** Writes the acceleration at u = (x, y) into `out` at `at`. */
  accelerate(x: number, y: number, out: Float64Array, at: number): void {
    let ax = 0;
    let ay = 0;
    if (this.kind === CENTRAL) {
      const d = Math.sqrt(x * x + y * y);
      const f = (d > 0 ? this.alpha / d : 0) + this.beta;
      ax = f * x;
      ay = f * y;
    } else if (this.kind === LINEAR) {
      ax = this.ax + this.beta * (x - this.x0);
      ay = this.ay + this.beta * (y - this.y0);
    }
    out[at] = this.freeX ? ax : 0;
    out[at + 1] = this.freeY ? ay : 0;
  }
}
