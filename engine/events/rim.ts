import { addProduct, LONGEST_SERIES, type Motion, relativeAt, relativeSeries, SLOTS, valueAt } from '../motion/index.ts';
import { DISTANCE_ROUNDING, FLOOR } from '../tolerances.ts';
import { crossing, lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from './roots.ts';

const { LENGTH_H, ACCELERATION } = SLOTS;

const dx = new Float64Array(LONGEST_SERIES);
const dy = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/**
 * First time at which her centre crosses the rim of the placed circle, found by a march of safe steps. The guard is a
 * polynomial; after PATIENCE evaluations its coefficients say how far it stays above 0. So circling close to a rim costs
 * little, and nothing is stepped over. A crossing that is shallower than FLOOR, or than the rounding of the radius, may be
 * overlooked.
 * @param r - its radius, px
 * @param inward - true for entering, false for leaving
 * @param pull - bound of the circle's own acceleration, px/s²
 * @param from - where to begin, s after the start of the piece
 * @param atZero - she is on the rim, having just crossed it the other way
 * @returns s after the start of the piece; -1 if there is none before the piece ends
 */
export function rimTime(m: Motion, r: number, inward: boolean, pull: number, from: number, atZero: boolean): number {
  const { s, toCircle, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const a = s[ACCELERATION] + m.kappa + pull;
  const sign = inward ? 1 : -1;
  const small = smallestStride(s[LENGTH_H]);
  const floor = 2 * r * Math.max(FLOOR, DISTANCE_ROUNDING * r);
  let t = from;
  let before = t;
  work.guards++;
  for (let n = 0; ; n++) {
    relativeAt(m, t);
    const d2 = toCircle[0] * toCircle[0] + toCircle[1] * toCircle[1];
    const d = Math.sqrt(d2);
    // (d - r)(d + r): the difference of squares would lose the digits of d - r
    let g = sign * (d - r) * (d + r);
    const slope = sign * 2 * (toCircle[0] * toCircle[2] + toCircle[1] * toCircle[3]);
    if (g < 0) {
      if (n > 0) return rimBetween(m, before, t, r, sign);
      if (!atZero && g < -1e-12 * r * r) return t;
      if (slope < 0 && !atZero) return t;
      g = 0;
    }
    if (t >= horizon) return -1;
    const left = horizon - t;
    const v = Math.sqrt(toCircle[2] * toCircle[2] + toCircle[3] * toCircle[3]);
    // g'' = sign (2 v^2 + 2 d.a); if a force acts, the bound holds for `cap` only
    let cap = left;
    let k = inward ? 0 : 2 * v * v;
    if (a > 0) {
      cap = Math.min(left, v / a + Math.sqrt(d / a) + 1e-3);
      const fast = v + a * cap;
      k = 2 * (d + fast * cap) * a + (inward ? 0 : 2 * fast * fast);
    }
    let step = Math.min(cap, safeStep(g + floor, slope, k));
    if (n >= PATIENCE && t + step < horizon) {
      work.guards++;
      const degree = rimSeries(m, t, g, sign);
      step = Math.max(step, safeStretch(guard, degree, g + floor, slope, 0, left));
    }
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, small, horizon);
  }
}

/** Writes the coefficients of sign (d² - r²) about `t` to `guard`, where the guard has `value`; returns their degree. */
function rimSeries(m: Motion, t: number, value: number, sign: number): number {
  const degree = relativeSeries(m, t, dx, dy);
  guard.fill(0);
  addProduct(dx, degree, dx, degree, sign, guard);
  addProduct(dy, degree, dy, degree, sign, guard);
  guard[0] = value;
  return 2 * degree;
}

/**
 * The root of the polynomial about `before`: close to the place on the rim where she is, it has more digits than distances
 * have.
 */
function rimBetween(m: Motion, before: number, behind: number, r: number, sign: number): number {
  const { toCircle } = m;
  m.work.roots++;
  relativeAt(m, before);
  const d = Math.sqrt(toCircle[0] * toCircle[0] + toCircle[1] * toCircle[1]);
  const degree = rimSeries(m, before, Math.max(0, sign * (d - r) * (d + r)), sign);
  return crossing(before, behind, (t) => valueAt(guard, degree, t - before));
}
