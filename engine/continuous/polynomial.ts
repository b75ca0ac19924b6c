/**
 * Value of a polynomial by Horner's rule: c[0] + c[1] t + ... + c[degree] t^degree.
 * @param c coefficients, lowest first
 */
export function valueAt(c: Float64Array, degree: number, t: number): number {
  let v = c[degree];
  for (let k = degree - 1; k >= 0; k--) v = v * t + c[k];
  return v;
}

/**
 * Value and derivative of a pair of polynomials (x, y) in one pass.
 * @param out receives x, y, x', y' from `at` on
 */
export function pairAt(x: Float64Array, y: Float64Array, degree: number, t: number, out: Float64Array, at: number): void {
  let vx = x[degree];
  let vy = y[degree];
  let dx = 0;
  let dy = 0;
  for (let k = degree - 1; k >= 0; k--) {
    dx = dx * t + vx;
    dy = dy * t + vy;
    vx = vx * t + x[k];
    vy = vy * t + y[k];
  }
  out[at] = vx;
  out[at + 1] = vy;
  out[at + 2] = dx;
  out[at + 3] = dy;
}
