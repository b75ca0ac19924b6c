import { addProduct, LONGEST_SERIES, type Motion, relativeAt, relativeSeries, SLOTS, valueAt } from '../motion/index.ts';
import { DISTANCE_ROUNDING, FLOOR } from '../tolerances.ts';
import { crossing, lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from './roots.ts';

const { NEXT, LENGTH_H, ACCELERATION } = SLOTS;

const dx = new Float64Array(LONGEST_SERIES);
const dy = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/**
 * First time at which her centre crosses the rim of the placed circle, found by a march of safe steps. The guard is a
 * polynomial; after PATIENCE evaluations its coefficients say how far it stays above 0. So circling close to a rim costs
 * little, and nothing is stepped over. A dip across it that is shallower than FLOOR, or than the rounding of the radius, is
 * none: rounding alone may take her as far where she moves along its tangent.
 * @param r - its radius, px
 * @param inward - true for entering, false for leaving
 * @param pull - bound of the circle's own acceleration, px/s²
 * @param from - where to begin, s after the start of the piece
 * @param atZero - she is on the rim, having just crossed it the other way
 * @returns s after the start of the piece; -1 if there is none before the piece ends
 */
export function rimTime(m: Motion, r: number, inward: boolean, pull: number, from: number, atZero: boolean): number {
  const { s, toCircle, work } = m;
  const end = s[LENGTH_H];
  const horizon = Math.min(m.horizon, end);
  const a = s[ACCELERATION] + m.kappa + pull;
  const sign = inward ? 1 : -1;
  const small = smallestStride(end);
  const floor = 2 * r * Math.max(FLOOR, DISTANCE_ROUNDING * r);
  let limit = horizon;
  let t = from;
  let before = t;
  let beyond = 0;
  work.guards++;
  for (let n = 0; ; n++) {
    relativeAt(m, t);
    const d2 = toCircle[0] * toCircle[0] + toCircle[1] * toCircle[1];
    const d = Math.sqrt(d2);
    // (d - r)(d + r): the difference of squares would lose the digits of d - r
    const g = sign * (d - r) * (d + r);
    const slope = sign * 2 * (toCircle[0] * toCircle[2] + toCircle[1] * toCircle[3]);
    if (t === from && g < 0) {
      if (!atZero && g < -1e-12 * r * r) return t;
      beyond = g;
    }
    const isBelow = g < 0 && (t > from || (slope < 0 && !atZero));
    if (t >= horizon) {
      if (!isBelow) return -1;
      limit = end;
    }
    const left = limit - t;
    // g'' = sign (2 v^2 + 2 d.a); if a force acts, the bounds hold for `cap` only
    let cap = left;
    let fast = Math.sqrt(toCircle[2] * toCircle[2] + toCircle[3] * toCircle[3]);
    let bend = 0;
    if (a > 0) {
      cap = Math.min(left, fast / a + Math.sqrt(d / a) + 1e-3);
      fast += a * cap;
      bend = 2 * (d + fast * cap) * a;
    }
    const k = inward ? bend : bend + 2 * fast * fast;
    // then it goes farther than the floor for certain, as in the marches to contacts and pairs
    const isSteep = slope * slope > 2 * (inward ? bend + 2 * fast * fast : bend) * floor;
    if (isBelow && ((isSteep && slope < 0) || g - beyond < -floor)) {
      if (t === from) return t;
      const time = rimBetween(m, before, t, r, sign);
      // beyond the horizon, what is beside the event found before is at its instant
      return limit === horizon || Math.abs((time - s[NEXT]) * slope) > floor ? time : s[NEXT];
    }
    // no run lasts 30 years: on an endless coast, what is left of a velocity may be rounding
    if (t >= end || t > 1e9) return -1;
    // on the rim, at rest across it, she crosses it at once if she is drawn across, even if a fixed step soon leads her back
    if (t === from && !isSteep && Math.abs(g) <= floor && slope <= 1e-14 * d * fast) {
      rimSeries(m, t, 0, sign);
      if (guard[2] < -1e-12 * (bend + fast * fast)) return rimBetween(m, t, t + small, r, sign);
    }
    const above = Math.max(0, g);
    let step = Math.min(cap, safeStep(above + floor, slope, k));
    if (n >= PATIENCE && t + step < limit) {
      work.guards++;
      const degree = rimSeries(m, t, above, sign);
      step = Math.max(step, safeStretch(guard, degree, above + floor, slope, 0, left));
    }
    if (!(t + step < limit)) {
      if (limit === end || !(isBelow || t + safeStep(above, slope, k) < limit)) return -1;
      // by the floor the step may reach beyond an event at the same instant as one that was found before
      limit = end;
      continue;
    }
    if (isSteep ? g >= 0 : g >= floor) before = t;
    t = lookNext(t, step, small, limit);
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
