/**
 * How far a guard can be followed safely: the largest t with g + dg t - k t^2 / 2 >= 0 on [0, t].
 * With k no less than -g'' everywhere ahead, g cannot reach 0 before; near a simple root the steps converge to it
 * quadratically from the safe side, past a near miss they stride over it.
 * @param g value of the guard, >= 0
 * @param dg its derivative
 * @param k bound on how fast the derivative can fall, >= 0
 * @returns t >= 0, perhaps Infinity
 */
export function safeStep(g: number, dg: number, k: number): number {
  const root = Math.sqrt(dg * dg + 2 * k * g);
  if (dg < 0) return (2 * g) / (root - dg);
  if (k === 0) return Number.POSITIVE_INFINITY;
  // where the product under the root is too small for a number
  return root > 0 ? (dg + root) / k : Math.sqrt((2 * g) / k);
}

/**
 * The smallest stride past a guard that touches zero without crossing it, s. Between two looks a stride `d` apart at which
 * the guard is not negative it is above -k d^2 / 8: with this stride and any k up to 1e8 that is above -1.3e-13.
 * @param length natural length of the piece, s
 */
export function smallestStride(length: number): number {
  return Math.min(1e-10, length * 1e-6);
}

/** More than the rounding of a time, as a share of it. */
const TIME_ROUNDING = 2.3e-16;

/**
 * Where a march looks next, s: a step on, `small` at least, and never at the same time again. On a coast without an end times grow
 * so large that a small stride is lost in them.
 */
export function lookNext(t: number, step: number, small: number, horizon: number): number {
  const next = t + Math.max(step, small);
  return Math.min(horizon, next > t ? next : t + t * TIME_ROUNDING);
}

/**
 * Looks after which a march that has neither crossed nor passed its guard takes the guard's polynomial to hand: a step by its
 * coefficients costs tens of looks, but where a guard stays near 0 for long it is as long as the piece.
 */
export const PATIENCE = 32;

/** A stretch of which no more than this many halvings are safe is shorter than the smallest stride. */
const MOST_HALVINGS = 44;

/**
 * How far a polynomial, less `bend` t^2 / 2, stays at or above 0, given as its coefficients about the present place:
 * a safe step, which takes the exact second derivative and all beyond it into account. On [0, h]
 * p(t) >= c0 + c1 t + (c2 - F(h)) t^2 with F(h) = sum over k >= 3 of max(0, -ck) h^(k - 2), since h^(k - 2) t^2 >= t^k there; so
 * the root of that parabola is safe as far as h. The longest of h = longest, longest / 2, ... that it reaches is taken.
 * @param c coefficients from the second on are used
 * @param c0 value, >= 0
 * @param c1 slope
 * @param bend bound on what else bends it down, >= 0
 * @param longest how far the coefficients and `bend` hold; Infinity only for a parabola
 */
export function safeStretch(c: Float64Array, degree: number, c0: number, c1: number, bend: number, longest: number): number {
  let best = 0;
  for (let h = longest, halvings = 0; h > best && halvings < MOST_HALVINGS; h /= 2, halvings++) {
    let fall = 0;
    for (let k = degree; k > 2; k--) fall = (fall + Math.max(0, -c[k])) * h;
    if (degree >= 2) fall -= c[2];
    const step = parabolaStep(c0, c1, 2 * fall + bend);
    if (step >= h) return h;
    if (degree <= 2) return step;
    best = Math.max(best, step);
  }
  return best;
}

/** {@link safeStep} where the guard may also bend up: k < 0. */
function parabolaStep(g: number, dg: number, k: number): number {
  if (k >= 0) return safeStep(g, dg, k);
  if (dg >= 0) return Number.POSITIVE_INFINITY;
  const square = dg * dg + 2 * k * g;
  return square < 0 ? Number.POSITIVE_INFINITY : (2 * g) / (Math.sqrt(square) - dg);
}
