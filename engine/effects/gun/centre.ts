import { crossing, lookNext, safeStep } from '../../events/index.ts';
import { lookAt, type Motion, pairAt, placeAt, SLOTS } from '../../motion/index.ts';

const { SIDE, LINE_STEEP, DEGREE, LENGTH_H, ACCELERATION, MEETS } = SLOTS;

/**
 * Her signed distance from the centre, or the target's from her, along the main axis of her line. Writes its derivative to
 * {@link rate}.
 */
type Way = (m: Motion, t: number) => number;

// working memory, px/s; an array, since V8 boxes numbers in module variables
const rate = new Float64Array(1);

/**
 * When she passes the centre on a straight line.
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if not before the piece ends
 */
export function centreTime(m: Motion, from: number): number {
  return passTime(m, from, wayToCentre, m.s[ACCELERATION]);
}

/** When the target that she holds inside a field passes her centre; like {@link centreTime}. */
export function meetingTime(m: Motion, from: number): number {
  return passTime(m, from, wayToTarget, m.s[ACCELERATION] + m.kappa);
}

function wayToCentre(m: Motion, t: number): number {
  const { s, her } = m;
  pairAt(m.ux, m.uy, s[DEGREE], t, her, 0);
  rate[0] = s[SIDE] * her[2 + s[LINE_STEEP]];
  return s[SIDE] * her[s[LINE_STEEP]];
}

function wayToTarget(m: Motion, t: number): number {
  const { s, toTarget } = m;
  placeAt(m, t);
  lookAt(m, t);
  rate[0] = s[MEETS] * toTarget[2 + s[LINE_STEEP]];
  return s[MEETS] * toTarget[s[LINE_STEEP]];
}

/** First time at which a distance falls below 0; `k` bounds its second derivative, px/s². */
function passTime(m: Motion, from: number, way: Way, k: number): number {
  const { s, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  let t = from;
  let before = from;
  work.guards++;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    const g = way(m, t);
    const slope = rate[0];
    if (n === 0 && g <= 0 && slope >= 0) {
      // at the centre, moving away
    } else if (g < 0) {
      if (n === 0) return t;
      work.roots++;
      return crossing(before, t, (time) => way(m, time));
    }
    if (t >= horizon) return -1;
    const step = safeStep(Math.max(g, 0), slope, k);
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, s[LENGTH_H] * 1e-9, horizon);
  }
}
