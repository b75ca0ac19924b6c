import { crossing, lookNext, PATIENCE, safeStretch } from '../../events/index.ts';
import { lookAt, type Motion, placeAt, SLOTS, shift, TAYLOR_DEGREE } from '../../motion/index.ts';
import { SHORTEST_LAPSE } from '../../tolerances.ts';

const { LENGTH_H, ACCELERATION, OUTER } = SLOTS;

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
  const { s, her, toTarget, rim, work } = m;
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
  m.rim.series(x, y);
  about.set(m.rim.pressure);
  shift(about, about.length - 1, t);
}

function offBetween(m: Motion, before: number, behind: number): number {
  m.work.roots++;
  return crossing(before, behind, (t) => pressureAt(m, t));
}

/** What presses her onto the rim after `t`, px/s²; evaluates the motion as {@link weighAt} does. */
function pressureAt(m: Motion, t: number): number {
  weighAt(m, t);
  return m.rim.pressesIn;
}

/**
 * Writes the forces on her after `t` to `m.rim`, her place to `m.her`, and the vector to the centre of the force outside to
 * `m.toTarget`.
 */
export function weighAt(m: Motion, t: number): void {
  const { s, her, toTarget, rim } = m;
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
