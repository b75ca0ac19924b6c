/**
 * Evaluates a polynomial by Horner's rule: c[0] + c[1] t + ... + c[degree] t^degree.
 * @param c - coefficients, lowest first
 */
export function valueAt(c: Float64Array, degree: number, t: number): number {
  let v = c[degree];
  for (let k = degree - 1; k >= 0; k--) v = v * t + c[k];
  return v;
}

/**
 * Evaluates a pair of polynomials (x, y) and their derivatives in one pass.
 * @param out - receives x, y, x', y' from index `at` on
 */
export function pairAt(x: Float64Array, y: Float64Array, degree: number, t: number, out: Float64Array, at: number): void {
  if (t === 0) {
    out[at] = x[0];
    out[at + 1] = y[0];
    out[at + 2] = x[1];
    out[at + 3] = y[1];
    return;
  }
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

/** Changes coefficients about 0 into those about `t`: c[k] becomes the k-th derivative there divided by k!. */
export function shift(c: Float64Array, degree: number, t: number): void {
  if (t === 0) return;
  for (let i = 0; i < degree; i++) {
    for (let k = degree - 1; k >= i; k--) c[k] += t * c[k + 1];
  }
}

/** Adds `factor` a b to `out`, whose degree is the sum of both degrees. */
export function addProduct(
  a: Float64Array,
  degreeA: number,
  b: Float64Array,
  degreeB: number,
  factor: number,
  out: Float64Array,
): void {
  for (let i = 0; i <= degreeA; i++) {
    const f = factor * a[i];
    if (f === 0) continue;
    for (let k = 0; k <= degreeB; k++) out[i + k] += f * b[k];
  }
}
