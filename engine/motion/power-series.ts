/** Degree of a Taylor piece. A power of two, so that the root of this degree is a chain of square roots. */
export const TAYLOR_DEGREE = 16;

/** Length of an array that holds any series. */
export const LONGEST_SERIES = TAYLOR_DEGREE + 1;

const N = TAYLOR_DEGREE;
// working memory: power series of s = x2 + y2 and of w = s^(-1/2)
const s = new Float64Array(N + 1);
const w = new Float64Array(N + 1);

/** A force about the origin; see {@link Flow}. */
export interface DrivenFlow {
  /** px/s2 */
  readonly alpha: number;
  /** 1/s2 */
  readonly beta: number;
  /** False while the speed limit holds this axis: then there is no acceleration along it. */
  readonly freeX: boolean;
  readonly freeY: boolean;
  /** px/s2 */
  readonly steadyX: number;
  readonly steadyY: number;
  readonly isSteady: boolean;
}

/**
 * Power series of u'' = alpha u / |u| + beta u + w with a steady force w, or with an axis that the speed limit holds. Energy is
 * not conserved then, so {@link centralSeries} does not apply.
 *
 * The recurrences are Cauchy products, with s = u.u and w = s^(-1/2), from s w' = -s' w / 2 (Jorba and Zou 2005, prop. 1). On
 * entry x[0..1], y[0..1] hold place and velocity. On return they hold all coefficients.
 * @param px - if given, the series of a body with p'' = kappa u / |u| (the target's recoil); its first two coefficients are
 * kept
 * @param py - likewise
 */
export function drivenSeries(
  x: Float64Array,
  y: Float64Array,
  { alpha, beta, freeX, freeY, steadyX, steadyY, isSteady }: DrivenFlow,
  px: Float64Array | null,
  py: Float64Array | null,
  kappa: number,
): void {
  for (let n = 0; n <= N - 2; n++) {
    let sn = 0;
    const half = n >> 1;
    for (let k = 0; k < n - half; k++) sn += x[k] * x[n - k] + y[k] * y[n - k];
    sn *= 2;
    if ((n & 1) === 0) sn += x[half] * x[half] + y[half] * y[half];
    s[n] = sn;
    if (n === 0) {
      w[0] = 1 / Math.sqrt(sn);
    } else {
      let wn = 0;
      for (let k = 1; k <= n; k++) wn += (0.5 * k - n) * s[k] * w[n - k];
      w[n] = wn / (n * s[0]);
    }
    let wx = 0;
    let wy = 0;
    for (let k = 0; k <= n; k++) {
      const c = w[n - k];
      wx += c * x[k];
      wy += c * y[k];
    }
    const f = 1 / ((n + 1) * (n + 2));
    if (px !== null && py !== null) {
      px[n + 2] = kappa * wx * f;
      py[n + 2] = kappa * wy * f;
    }
    x[n + 2] = freeX ? (alpha * wx + beta * x[n]) * f : px === null ? 0 : -px[n + 2];
    y[n + 2] = freeY ? (alpha * wy + beta * y[n]) * f : py === null ? 0 : -py[n + 2];
    if (n > 0 || !isSteady) continue;
    if (freeX) x[2] += steadyX / 2;
    if (freeY) y[2] += steadyY / 2;
  }
}

/**
 * Power series of u'' = a + beta (u - u(0)): motion along a line through the centre, where the direction of the pull is
 * constant. It is an entire function, so the pieces are long.
 * @param ax - x of the acceleration at the start
 * @param ay - y of the acceleration at the start
 */
export function linearSeries(x: Float64Array, y: Float64Array, ax: number, ay: number, beta: number): void {
  x[2] = ax / 2;
  y[2] = ay / 2;
  for (let n = 1; n <= N - 2; n++) {
    const f = beta / ((n + 1) * (n + 2));
    x[n + 2] = f * x[n];
    y[n + 2] = f * y[n];
  }
}

const sixteenthRoot = (q: number): number => Math.sqrt(Math.sqrt(Math.sqrt(Math.sqrt(q))));

/**
 * The length for which a series is accurate, s: the last two terms stay below `tolerance`, and so do their rates of change,
 * since an error of velocity lasts (Jorba and Zou 2005, 3.2; near a centre, where pieces are short, the rates decide). It uses
 * only + - * / and square roots, so that every JavaScript engine takes the same step.
 * @param tolerance - px, and px/s
 * @param longest - returned if the terms vanish, s
 */
export function taylorStep(x: Float64Array, y: Float64Array, tolerance: number, longest: number): number {
  const last = Math.abs(x[N]) + Math.abs(y[N]);
  const before = Math.abs(x[N - 1]) + Math.abs(y[N - 1]);
  let h = longest;
  if (last > 0) {
    const root = sixteenthRoot(tolerance / last);
    // for rates the 15th root is needed: root^(16/15), a little below root^(17/16)
    h = Math.min(h, root < 1 ? root * sixteenthRoot(root) : root);
  }
  for (let i = 0; i < 400; i++) {
    const h2 = h * h;
    const h4 = h2 * h2;
    const h12 = h4 * h4 * h4;
    const rate = h < 1 ? 1 : h;
    if (before * h12 * h2 * rate <= tolerance && last * h12 * h2 * h * rate <= tolerance) break;
    h *= 0.9375;
  }
  return h;
}
