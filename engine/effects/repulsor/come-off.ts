import { crossing, lookNext, PATIENCE, safeStretch } from '../../events/index.ts';
import { lookAt, type Motion, placeAt, SLOTS, shift, TAYLOR_DEGREE } from '../../motion/index.ts';
import { SHORTEST_LAPSE } from '../../tolerances.ts';

const { LENGTH_H, ACCELERATION, OUTER } = SLOTS;

/** Once the series of the pressure leads, one that falls below 0 by less than this may be overlooked, px/s2. */
const OVERLOOKED = 1e-10;

const x = new Float64Array(TAYLOR_DEGREE + 1);
const y = new Float64Array(TAYLOR_DEGREE + 1);
const about = new Float64Array(TAYLOR_DEGREE - 1);

/**
 * When nothing presses her onto the rim any more that she slides along: she flies out faster than the force outside drives her in.
 * The pressure can't fall faster than a bound, so strides of pressure / bound step over nothing.
 * Where it stays near 0 for long its series says, after PATIENCE looks, how far it does.
 * @param from s from the start of the piece
 * @returns s from there, too; -1: not before the piece ends
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
    // within the cap the distance stays above 0.72 d and speeds below these
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

/** Into `about` the coefficients of the pressure about `t`; made again each time, since the piece may have been restored. */
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

/** What presses her onto the rim after `t`, px/s2; looks as {@link weighAt} does. */
function pressureAt(m: Motion, t: number): number {
  weighAt(m, t);
  return m.rim.pressesIn;
}

/** Finds into `m.rim` what acts on her after `t`, into `m.her` where she is, into `m.toTarget` where the centre of the force outside is. */
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
