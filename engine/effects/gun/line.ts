import { crossing, lookNext, safeStep } from '../../events/index.ts';
import {
  beginLine,
  holdsTarget,
  LINEAR,
  LINES,
  lookAt,
  MEETINGS,
  type Motion,
  pairAt,
  placeAt,
  RECORDS,
  SLOTS,
} from '../../motion/index.ts';
import { SMALLEST_ORBIT } from '../../tolerances.ts';

const { SIDE, LINE_STEEP, DEGREE, LENGTH_H, ACCELERATION, MEETS, TARGET, KIND, BASE_X, BASE_Y, COS, SIN, LINE_X, LINE_Y, LINE } =
  SLOTS;
const { ROCK } = RECORDS;
const { NONE } = LINES;
const { AHEAD, BEHIND, TOGETHER } = MEETINGS;

/**
 * Her signed distance from the centre, or the target's from her, along the main axis of her line. Writes its derivative to
 * {@link rate}.
 */
type LineDistance = (m: Motion, t: number) => number;

// working memory, px/s; an array, since V8 boxes numbers in module variables
const rate = new Float64Array(1);

/**
 * When she passes the centre on a straight line.
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if not before the piece ends
 */
export function centreTime(m: Motion, from: number): number {
  return passTime(m, from, distanceToCentre, m.s[ACCELERATION]);
}

/** When the target that she holds inside a field passes her centre; like {@link centreTime}. */
export function meetingTime(m: Motion, from: number): number {
  return passTime(m, from, distanceToTarget, m.s[ACCELERATION] + m.kappa);
}

function distanceToCentre(m: Motion, t: number): number {
  const { s, her } = m;
  pairAt(m.ux, m.uy, s[DEGREE], t, her, 0);
  rate[0] = s[SIDE] * her[2 + s[LINE_STEEP]];
  return s[SIDE] * her[s[LINE_STEEP]];
}

function distanceToTarget(m: Motion, t: number): number {
  const { s, toTarget } = m;
  placeAt(m, t);
  lookAt(m, t);
  rate[0] = s[MEETS] * toTarget[2 + s[LINE_STEEP]];
  return s[MEETS] * toTarget[s[LINE_STEEP]];
}

/** First time at which a distance falls below 0; `k` bounds its second derivative, px/s². */
function passTime(m: Motion, from: number, distance: LineDistance, k: number): number {
  const { s, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  let t = from;
  let before = from;
  work.guards++;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    const g = distance(m, t);
    const slope = rate[0];
    if (n === 0 && g <= 0 && slope >= 0) {
      // at the centre, moving away
    } else if (g < 0) {
      if (n === 0) return t;
      work.roots++;
      return crossing(before, t, (time) => distance(m, time));
    }
    if (t >= horizon) return -1;
    const step = safeStep(Math.max(g, 0), slope, k);
    if (!(t + step < horizon)) return -1;
    before = t;
    t = lookNext(t, step, s[LENGTH_H] * 1e-9, horizon);
  }
}

/**
 * She is held inside a field. If the target is on her line, it is ahead of her or behind her until they meet, which is an
 * event: there the box flips, and so does the acceleration of a target that is dragged along. A target that would swing about
 * her by less than {@link SMALLEST_ORBIT} stays in her centre: it is accelerated as she is, which the gun is strong enough to
 * do.
 * @returns whether it is on the line; if not, the box follows it
 */
export function holdOnLine(m: Motion): boolean {
  const { s, ux, uy, recoil } = m;
  const target = s[TARGET];
  const o = m.rocks + ROCK * target;
  const x = (recoil ? s[o] : m.targetX[target]) - s[BASE_X] - ux[0];
  const y = (recoil ? s[o + 1] : m.targetY[target]) - s[BASE_Y] - uy[0];
  const vx = (recoil ? s[o + 2] : 0) - ux[1];
  const vy = (recoil ? s[o + 3] : 0) - uy[1];
  // at rest in the centre of the field any line through it is hers, unless a steady force drives her along one
  const rests = !m.flow.isSteady && ux[0] === 0 && uy[0] === 0 && ux[1] === 0 && uy[1] === 0;
  if (rests && (s[LINE] === NONE || !holdsTarget(m, target))) {
    if (x !== 0 || y !== 0) beginLine(m, x, y);
    else if (vx !== 0 || vy !== 0) beginLine(m, vx, vy);
  }
  if (!holdsTarget(m, target)) return false;

  const steep = s[LINE_STEEP] === 1;
  const main = steep ? s[LINE_Y] : s[LINE_X];
  const along = (steep ? y : x) / main;
  const speed = (steep ? vy : vx) / main;
  const push = s[KIND] === LINEAR ? s[SIDE] * m.rules.push : 0;
  const strongest = Math.abs(push) + m.flow.steadyStrength;
  const back = m.kappa - strongest;
  const energy = (speed * speed) / 2 + (m.kappa + strongest) * Math.abs(along);
  if (back > 0 ? energy < back * SMALLEST_ORBIT : along === 0 && speed === 0 && push === 0) {
    s[MEETS] = TOGETHER;
    if (!recoil) return true;
    s[o] = s[BASE_X] + ux[0];
    s[o + 1] = s[BASE_Y] + uy[0];
    s[o + 2] = ux[1];
    s[o + 3] = uy[1];
    return true;
  }
  // what no force holds in her centre stays behind when the push takes her away
  const side = along !== 0 ? along : speed !== 0 ? speed : -push;
  s[MEETS] = side < 0 ? BEHIND : AHEAD;
  s[COS] = s[MEETS] * s[LINE_X];
  s[SIN] = s[MEETS] * s[LINE_Y];
  return true;
}

/** Puts the target into her very centre, exact to the last bit along the line. */
export function putInCentre(m: Motion): void {
  const { s, ux, uy, recoil } = m;
  const target = s[TARGET];
  const o = m.rocks + ROCK * target;
  if (ux[0] === 0 && uy[0] === 0 && ux[1] === 0 && uy[1] === 0) {
    // at rest in the centre of the field the smallest displacement would grow; at the speed limit she may pass the centre
    s[o] = s[BASE_X];
    s[o + 1] = s[BASE_Y];
    return;
  }
  // the other coordinate follows from the line
  if (s[LINE_STEEP] === 1) uy[0] = (recoil ? s[o + 1] : m.targetY[target]) - s[BASE_Y];
  else ux[0] = (recoil ? s[o] : m.targetX[target]) - s[BASE_X];
}
