import { crossing, lookNext, safeStretch, smallestStride } from '../../events/index.ts';
import { CENTRAL, Flow, LINEAR, LONGEST_SERIES, type Motion, pairAt, SLIDE, SLOTS, shift, valueAt } from '../../motion/index.ts';
import { letGoTime } from '../repulsor/index.ts';

const { DEGREE, LENGTH_H } = SLOTS;

/** What may be overlooked: px/s beyond the limit, px beyond the centre. Less than ten times the rounding error of the limit. */
const OVERLOOKED = 1e-12;

// working memory: the force that would act if the axis were free
const force = new Flow();
const there = new Float64Array(4);
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
      if (sign * drive(m, axis, time) > 0) return time;
      t = turnTime(m, time, (later) => -sign * drive(m, axis, later));
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
  if (m.flow.kind === SLIDE) return letGoTime(m, axis, from);
  // on a line both axes are free; without a force nothing drives her back
  if (m.flow.isSteady) return steadyFreeTime(m, axis, held, from);
  if (m.flow.kind !== CENTRAL) return -1;
  return firstBelow(m, placeGuard(m, axis, m.flow.alpha > 0 ? held : -held), from, false);
}

/**
 * The same with a steady force, where the place does not tell in which direction she is driven. Only the end of the piece is
 * examined; the stepper keeps the piece short.
 */
function steadyFreeTime(m: Motion, axis: number, held: number, from: number): number {
  m.work.guards++;
  return turnTime(m, from, (t) => held * drive(m, axis, t));
}

/**
 * When a value that is not negative at `from` falls below 0, provided that it is below 0 at the end of the piece; otherwise -1.
 */
function turnTime(m: Motion, from: number, along: (t: number) => number): number {
  if (along(from) < 0) return from;
  const end = Math.min(m.horizon, m.s[LENGTH_H]);
  return along(end) < 0 ? crossing(from, end, along) : -1;
}

/** The acceleration along the axis after `t` if the axis were free, px/s². */
function drive(m: Motion, axis: number, t: number): number {
  const { flow } = m;
  pairAt(m.ux, m.uy, m.s[DEGREE], t, there, 0);
  // on a line both axes are free
  if (flow.kind === LINEAR) {
    flow.accelerate(there[0], there[1], there, 0);
    return there[axis];
  }
  force.kind = flow.kind;
  force.alpha = flow.alpha;
  force.beta = flow.beta;
  force.setSteady(flow.steadyX, flow.steadyY);
  force.accelerate(there[0], there[1], there, 0);
  return there[axis];
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
