import { crossing, lookNext, PATIENCE, safeStretch } from '../../events/index.ts';
import { lookAt, type Motion, placeAt, SLOTS, shift, TAYLOR_DEGREE } from '../../motion/index.ts';
import { SHORTEST_LAPSE } from '../../tolerances.ts';
import { rimOf } from './slide.ts';

const { LENGTH_H, ACCELERATION, OUTER, LIMIT_X, LIMIT_Y } = SLOTS;

/** Once the series of the pressure is used, a dip below 0 that is shallower than this may be overlooked, px/s². */
const OVERLOOKED = 1e-10;

const x = new Float64Array(TAYLOR_DEGREE + 1);
const y = new Float64Array(TAYLOR_DEGREE + 1);
const about = new Float64Array(TAYLOR_DEGREE - 1);

/**
 * When she comes off the rim that she slides along: nothing presses her onto it any more, since she flies out faster than the
 * force outside drives her in. The pressure cannot fall faster than a bound, so strides of pressure / bound step over nothing.
 * Where the pressure stays near 0 for long, its series gives the strides after PATIENCE evaluations.
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if not before the piece ends
 */
export function comeOffTime(m: Motion, from: number): number {
  const { s, her, toTarget, work } = m;
  const rim = rimOf(m);
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const stride = Math.min(SHORTEST_LAPSE, s[LENGTH_H] / 64);
  const a = s[ACCELERATION];
  const relative = a + m.kappa;
  let t = from;
  let before = from;
  work.guards++;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    const pressure = pressureAt(m, t);
    if (pressure < 0) return t === from ? t : offBetween(m, before, t);
    if (t >= horizon) return -1;
    const d = Math.sqrt(toTarget[0] * toTarget[0] + toTarget[1] * toTarget[1]);
    const v = Math.sqrt(toTarget[2] * toTarget[2] + toTarget[3] * toTarget[3]);
    const root = Math.sqrt(relative * d);
    // within the cap the distance stays above 0.72 d, and the speeds below these
    const cap = (0.25 * d) / (v + root);
    const fast = v + 0.25 * root;
    const own = Math.sqrt(her[2] * her[2] + her[3] * her[3]) + a * cap;
    const turning = (Math.abs(rim.alpha) / (0.72 * d) + rim.beta) * fast;
    const falls = turning + (a * own + 2 * own * a) / rim.radius;
    let step = Math.min(cap, falls > 0 ? pressure / falls : Number.POSITIVE_INFINITY);
    if (n >= PATIENCE && rim.freeX && rim.freeY && t + step < horizon) {
      pressureSeries(m, t);
      step = Math.max(step, safeStretch(about, about.length - 1, pressure + OVERLOOKED, about[1], 0, horizon - t));
    }
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, stride, horizon);
  }
}

/**
 * Writes the coefficients of the pressure about `t` to `about`. They are computed anew each time, since the piece may have been
 * restored.
 */
function pressureSeries(m: Motion, t: number): void {
  m.budget.look(8);
  for (let k = 0; k < 2; k++) {
    x[k] = m.ux[k];
    y[k] = m.uy[k];
  }
  rimOf(m).series(x, y);
  about.set(rimOf(m).pressure);
  shift(about, about.length - 1, t);
}

function offBetween(m: Motion, before: number, behind: number): number {
  m.work.roots++;
  return crossing(before, behind, (t) => pressureAt(m, t));
}

/** What presses her onto the rim after `t`, px/s²; evaluates the motion as {@link weighAt} does. */
function pressureAt(m: Motion, t: number): number {
  weighAt(m, t);
  return rimOf(m).pressesIn;
}

/**
 * Writes the forces on her after `t` to the rim's flow, her place to `m.her`, and the vector to the centre of the force outside to
 * `m.toTarget`.
 */
function weighAt(m: Motion, t: number): void {
  const { s, her, toTarget } = m;
  const rim = rimOf(m);
  placeAt(m, t);
  if (s[OUTER] < 0) {
    lookAt(m, t);
  } else {
    toTarget[0] = rim.qx - her[0];
    toTarget[1] = rim.qy - her[1];
    toTarget[2] = -her[2];
    toTarget[3] = -her[3];
  }
  rim.weigh(her[0], her[1], her[2], her[3], -toTarget[0], -toTarget[1]);
}

const acceleration = new Float64Array(2);

/**
 * She slides along a rim while the speed limit holds an axis: when is the axis freed, since the forces between two bounces
 * would no longer drive her further along it? Where that drive is 0 she moves alike held or free, so it is computed as if the
 * axis were free.
 *
 * Let f be the force outside, n the direction outwards and s the share of the time in which f acts. The drive is s f + (1 - s)
 * push n with s = (push + S) / (push - P) <= 1, S = |v|² / radius and P = f.n <= 0. So it changes by at most (|S'| + |P'|) /
 * push (|f| + push) + |f'| + push |n'| per second.
 * @param axis - 0 for x, 1 for y
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if not before the piece ends
 */
export function letGoTime(m: Motion, axis: number, from: number): number {
  const { s, her, toTarget, work } = m;
  const rim = rimOf(m);
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const stride = Math.min(SHORTEST_LAPSE, s[LENGTH_H] / 64);
  const a = s[ACCELERATION];
  let t = from;
  let before = from;
  work.guards++;
  for (;;) {
    m.budget.look(1);
    const drives = driveAt(m, axis, t);
    if (drives < 0) return t === from ? t : goneBetween(m, axis, before, t);
    if (t >= horizon) return -1;
    const d = Math.sqrt(toTarget[0] * toTarget[0] + toTarget[1] * toTarget[1]);
    const v = Math.sqrt(toTarget[2] * toTarget[2] + toTarget[3] * toTarget[3]);
    // bounds of distance and speeds as in `comeOffTime`
    const root = Math.sqrt((a + m.kappa) * d);
    const cap = (0.25 * d) / (v + root);
    const fast = v + 0.25 * root;
    const own = Math.sqrt(her[2] * her[2] + her[3] * her[3]) + a * cap;
    const turning = (Math.abs(rim.alpha) / (0.72 * d) + rim.beta) * fast;
    const shares = (turning + (3 * a * own) / rim.radius) / m.rules.push;
    const falls = shares * (a + m.rules.push) + turning + (m.rules.push * own) / rim.radius;
    const step = Math.min(cap, falls > 0 ? drives / falls : Number.POSITIVE_INFINITY);
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, stride, horizon);
  }
}

function goneBetween(m: Motion, axis: number, before: number, behind: number): number {
  m.work.roots++;
  return crossing(before, behind, (t) => driveAt(m, axis, t));
}

/** Her acceleration along the axis, in the direction of the limit, if the axis were free, px/s². */
function driveAt(m: Motion, axis: number, t: number): number {
  const { s, her } = m;
  const rim = rimOf(m);
  const { freeX, freeY } = rim;
  rim.freeX = rim.freeY = true;
  weighAt(m, t);
  rim.accelerate(her[0], her[1], acceleration, 0);
  rim.freeX = freeX;
  rim.freeY = freeY;
  return s[axis === 0 ? LIMIT_X : LIMIT_Y] * acceleration[axis];
}
