import { crossing, lookNext, safeStep, safeStretch, smallestStride } from '../../events/index.ts';
import {
  actingForce,
  CENTRAL,
  LINEAR,
  LONGEST_SERIES,
  type Motion,
  pairAt,
  SLIDE,
  SLOTS,
  STEADY,
  shift,
  valueAt,
} from '../../motion/index.ts';
import { SHORTEST_LAPSE } from '../../tolerances.ts';

const { FIELD, DEGREE, LENGTH_H, ACCELERATION } = SLOTS;

/** What may be overlooked: px/s beyond the limit, px beyond the centre. Less than ten times the rounding error of the limit. */
const OVERLOOKED = 1e-12;

/** By how much the drive along an axis may fall below 0 unnoticed, px/s². */
const OVERLOOKED_DRIVE = 1e-10;

// working memory: her place and velocity, and how the drive changes at most
const there = new Float64Array(4);
const drift = new Float64Array(3);
/** The slope of what {@link drive} returns, px/s³; a bound of how fast the slope can fall; and for how long that holds, s. */
const SLOPE = 0;
const FALL = 1;
const CAP = 2;
const guard = new Float64Array(LONGEST_SERIES);
const about = new Float64Array(LONGEST_SERIES);

/**
 * When she reaches the limit along an axis and is driven further. Where she is driven back, a step exceeds the limit only by
 * its own error; it would be held and freed again endlessly.
 */
export function limitTime(m: Motion, axis: number, sign: number, from: number, released: boolean): number {
  const { kind, alpha } = m.flow;
  const driving = alpha > 0 ? sign : -sign;
  for (let t = from; ; ) {
    const time = firstBelow(m, velocityGuard(m, axis, sign), t, released && t === from);
    if (time < 0 || (kind !== CENTRAL && kind !== LINEAR)) return time;
    if (m.flow.isSteady) {
      if (drive(m, axis, sign, time) > 0) return time;
      t = turnTime(m, axis, -sign, time);
      if (t < 0) return -1;
      continue;
    }
    if (valueAt(guard, placeGuard(m, axis, driving), time) > 0) return time;
    t = firstBelow(m, placeGuard(m, axis, -driving), time, false);
    if (t < 0) return -1;
  }
}

/**
 * When the force would no longer drive her further along an axis that is held at the limit; -1 if not before the piece ends.
 */
export function freeTime(m: Motion, axis: number, held: number, from: number): number {
  if (m.flow.kind === SLIDE) return m.parts.sliding?.letGo(m, axis, from) ?? -1;
  // on a line both axes are free; without a force nothing drives her back
  if (m.flow.isSteady) return passesCentre(m) ? -1 : turnTime(m, axis, held, from);
  if (m.flow.kind !== CENTRAL) return -1;
  return firstBelow(m, placeGuard(m, axis, m.flow.alpha > 0 ? held : -held), from, false);
}

/** Whether she is so near to the centre of a force that this has no direction: a steady force alone does not tell what drives her. */
const passesCentre = (m: Motion): boolean => m.flow.kind === STEADY && actingForce(m) !== null;

/**
 * When the drive along an axis falls below 0, with a steady force: there her place does not tell in which direction she is
 * driven. It is found by a march of safe steps, which can overlook only a dip shallower than OVERLOOKED_DRIVE or shorter than
 * SHORTEST_LAPSE.
 */
function turnTime(m: Motion, axis: number, sign: number, from: number): number {
  const { s } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const stride = Math.min(SHORTEST_LAPSE, s[LENGTH_H] / 64);
  let before = from;
  m.work.guards++;
  for (let t = from; ; ) {
    m.budget.look(1);
    const g = drive(m, axis, sign, t);
    if (t === from && g < -OVERLOOKED_DRIVE) return t;
    if (t > from && g < 0) {
      m.work.roots++;
      return crossing(before, t, (time) => drive(m, axis, sign, time));
    }
    const step = Math.min(drift[CAP], safeStep(Math.max(0, g) + OVERLOOKED_DRIVE, drift[SLOPE], drift[FALL]));
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, stride, horizon);
  }
}

/**
 * Her own acceleration along the axis after `t` if the axis were free, times `sign`, px/s². The flow has her acceleration
 * relative to the base; recoil accelerates that, which does not count here. Writes to {@link drift} how it changes.
 *
 * Let f be the force, c its centre's direction u / |u| and d = |u|. f = alpha c + beta u + w, with |c'| <= |u'| / d and |c''| <=
 * |u''| / d + 3 |u'|² / d². While u moves by less than d / 4, the bounds of `contact.ts` hold: d stays above 0.75 d, and |u'|
 * below |u'| + sqrt(A d) / 4 where A bounds |u''|.
 */
function drive(m: Motion, axis: number, sign: number, t: number): number {
  const { s, flow } = m;
  pairAt(m.ux, m.uy, s[DEGREE], t, there, 0);
  const u = there[axis];
  const v = there[2 + axis];
  const a = s[ACCELERATION];
  const steady = axis === 0 ? flow.steadyX : flow.steadyY;
  const kappa = s[FIELD] < 0 ? m.kappa : 0;
  drift[SLOPE] = drift[FALL] = 0;
  drift[CAP] = Number.POSITIVE_INFINITY;
  if (flow.kind === LINEAR) {
    // on a line both axes are free
    const out = axis === 0 ? flow.outX : flow.outY;
    const from = axis === 0 ? flow.ax + flow.beta * (u - flow.x0) : flow.ay + flow.beta * (u - flow.y0);
    drift[SLOPE] = sign * flow.beta * v;
    drift[FALL] = flow.beta * a;
    return sign * (from + kappa * out);
  }
  if (flow.kind !== CENTRAL) return sign * steady;
  const alpha = flow.alpha + kappa;
  const d = Math.sqrt(there[0] * there[0] + there[1] * there[1]);
  const root = Math.sqrt(a * d);
  const speed = Math.sqrt(there[2] * there[2] + there[3] * there[3]);
  const fast = (speed + root / 4) / (0.75 * d);
  const radial = (there[0] * there[2] + there[1] * there[3]) / d;
  drift[SLOPE] = sign * ((alpha * (v - (u / d) * radial)) / d + flow.beta * v);
  drift[FALL] = Math.abs(alpha) * (a / (0.75 * d) + 3 * fast * fast) + flow.beta * a;
  drift[CAP] = (0.25 * d) / (speed + root);
  return sign * (alpha * (u / d) + flow.beta * u + steady);
}

/** Writes sign u, px, to `guard`; returns its degree. */
function placeGuard(m: Motion, axis: number, sign: number): number {
  const u = axis === 0 ? m.ux : m.uy;
  const degree = m.s[DEGREE];
  for (let k = 0; k <= degree; k++) guard[k] = sign * u[k];
  return degree;
}

/** Writes to `guard` how far she is below the limit, px/s; returns its degree. */
function velocityGuard(m: Motion, axis: number, sign: number): number {
  const u = axis === 0 ? m.ux : m.uy;
  const p = axis === 0 ? m.px : m.py;
  const degree = m.s[DEGREE] - 1;
  for (let k = 0; k <= degree; k++) guard[k] = -sign * (k + 1) * (u[k + 1] + (m.recoil ? p[k + 1] : 0));
  guard[0] += m.rules.speedLimit;
  return degree;
}

/**
 * First time in [from, horizon] at which the polynomial in `guard` is below 0, or -1. The coefficients about each time prove
 * the length of the next step, so nothing is overlooked but dips shallower than OVERLOOKED.
 * @param atZero - the guard is 0 at `from`, since the axis was freed then
 */
function firstBelow(m: Motion, degree: number, from: number, atZero: boolean): number {
  const { s } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const small = smallestStride(s[LENGTH_H]);
  let before = from;
  m.work.guards++;
  for (let t = from; ; ) {
    m.budget.look(4);
    for (let k = 0; k <= degree; k++) about[k] = guard[k];
    shift(about, degree, t);
    const g = about[0];
    if (g < 0 && !(atZero && t === from)) return t === from ? t : rootBetween(m, degree, before, t);
    const slope = degree > 0 ? about[1] : 0;
    const step = safeStretch(about, degree, Math.max(0, g) + OVERLOOKED, slope, 0, horizon - t);
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, small, horizon);
  }
}

/** The root, by the coefficients about `before`: where the guard is nearly 0 there, they have more digits. */
function rootBetween(m: Motion, degree: number, before: number, behind: number): number {
  m.work.roots++;
  for (let k = 0; k <= degree; k++) about[k] = guard[k];
  shift(about, degree, before);
  return crossing(before, behind, (t) => valueAt(about, degree, t - before));
}
