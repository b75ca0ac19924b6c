/**
 * The safe step of conservative advancement: the largest t with g + dg t - k t² / 2 >= 0 on [0, t]. If k >= -g'' everywhere
 * ahead, the guard cannot reach 0 earlier. Near a simple root the steps converge to it quadratically from the safe side; past a
 * near miss they carry on beyond it.
 * @param g - value of the guard, >= 0
 * @param dg - its derivative
 * @param k - bound of how fast the derivative can fall, >= 0
 * @returns t >= 0, possibly Infinity
 */
export function safeStep(g: number, dg: number, k: number): number {
  const root = Math.sqrt(dg * dg + 2 * k * g);
  if (dg < 0) return (2 * g) / (root - dg);
  if (k === 0) return Number.POSITIVE_INFINITY;
  // where the product under the root underflows
  return root > 0 ? (dg + root) / k : Math.sqrt((2 * g) / k);
}

/**
 * The smallest stride past a guard that touches zero without crossing it, s. If the guard is not negative at two times `d`
 * apart, it is above -k d² / 8 between them: for this stride and any k up to 1e8, above -1.3e-13.
 * @param length - natural length of the piece, s
 */
export function smallestStride(length: number): number {
  return Math.min(1e-10, length * 1e-6);
}

/** Relative rounding error of a time, with room. */
const TIME_ROUNDING = 2.3e-16;

/**
 * The next time at which a march evaluates its guard, s: one step on, but at least `small`, and never the same time again. On a
 * coast without an end, times grow so large that rounding would swallow a small stride.
 */
export function lookNext(t: number, step: number, small: number, horizon: number): number {
  const next = t + Math.max(step, small);
  return Math.min(horizon, next > t ? next : t + t * TIME_ROUNDING);
}

/**
 * A march that has neither crossed nor passed its guard after this many evaluations continues with the guard's polynomial. A
 * step by its coefficients costs tens of evaluations, but where a guard stays near 0 for long it can be as long as the piece.
 */
export const PATIENCE = 32;

/** If more halvings than this are needed, the safe stretch is shorter than the smallest stride. */
const MOST_HALVINGS = 44;

/**
 * How far a polynomial minus `bend` t² / 2 certainly stays at or above 0. The polynomial is given by its coefficients about the
 * present time, so the second derivative and all higher ones are taken into account exactly.
 *
 * On [0, h], p(t) >= c0 + c1 t + (c2 - F(h)) t² with F(h) = sum over k >= 3 of max(0, -ck) h^(k - 2), since h^(k - 2) t² >= t^k
 * there. So the root of that parabola is safe as far as h. The result is for the longest of h = longest, longest / 2, ... that
 * it reaches.
 * @param c - coefficients; used from the second on
 * @param c0 - value, >= 0
 * @param c1 - slope
 * @param bend - bound of what else bends it down, >= 0
 * @param longest - how far the coefficients and `bend` hold; Infinity only for a parabola
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

/** {@link safeStep} for a guard that may also bend up: k < 0. */
function parabolaStep(g: number, dg: number, k: number): number {
  if (k >= 0) return safeStep(g, dg, k);
  if (dg >= 0) return Number.POSITIVE_INFINITY;
  const square = dg * dg + 2 * k * g;
  return square < 0 ? Number.POSITIVE_INFINITY : (2 * g) / (Math.sqrt(square) - dg);
}

/** Times nearer than this count as equal, s. */
const SAME = 1e-19;

/** What begins within this time begins at once, s. */
const AT_ONCE = 1e-18;

/** Relative rounding error of a time: half a unit in the last place. */
const ROUNDING = 1.2e-16;

/** After this many evaluations the bracket must have shrunk to an eighth; otherwise it is halved. */
const HALVE_AFTER = 3;

/**
 * The moment at which a guard falls below 0, to the last bit of the time: regula falsi after Anderson and Björck (1973), with
 * halving where that is slow.
 * @param before - a time at which the guard is not below 0, s
 * @param behind - a later time at which it is, s
 * @param guard - its value at a time, s
 * @returns a time at which the guard is below 0, s
 */
export function crossing(before: number, behind: number, guard: (t: number) => number): number {
  let a = before;
  let b = behind;
  let atA = Math.max(0, guard(a));
  let atB = guard(b);
  if (!(atB < 0)) return b;
  let side = 0;
  let wide = Number.POSITIVE_INFINITY;
  for (let n = 0; ; n++) {
    const width = b - a;
    const least = Math.max(SAME, ROUNDING * b);
    if (width <= least) return b;
    let t = a + width * (atA / (atA - atB));
    if (n % HALVE_AFTER === 0) {
      if (width > wide / 8) t = a + width / 2;
      wide = width;
    }
    t = Math.min(Math.max(t, a + least), b - least);
    if (!(t > a && t < b)) t = a + width / 2;
    if (!(t > a && t < b)) return b;
    const g = guard(t);
    // the value at the end that stays is reduced, so that the next secant ends on its side of the root
    if (g < 0) {
      if (side < 0) atA *= g > atB ? 1 - g / atB : 0.5;
      b = t;
      atB = g;
      side = -1;
    } else {
      if (side > 0) atB *= g < atA ? 1 - g / atA : 0.5;
      a = t;
      atA = g;
      side = 1;
    }
  }
}

/** The same where two bodies may touch at `before` already and move into each other: then the result is `before` itself. */
export function overlapBetween(before: number, behind: number, gap: (t: number) => number): number {
  const t = crossing(before, behind, gap);
  return t - before < AT_ONCE ? before : t;
}
