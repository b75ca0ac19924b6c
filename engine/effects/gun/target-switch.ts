import { crossing, lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from '../../events/index.ts';
import {
  addProduct,
  LONGEST_SERIES,
  type Motion,
  pairAt,
  placeRock,
  relativeAt,
  relativeSeries,
  SLOTS,
  shift,
  valueAt,
} from '../../motion/index.ts';
import { SURPLUS, TIE, WIDEST_TIE } from '../../tolerances.ts';

const { START, TARGET, BASE_X, BASE_Y, DEGREE, LENGTH_H, ACCELERATION, SWITCH_TIME, SWITCHES } = SLOTS;

/** So many changes of target in one instant may be: with each one more a tie is ten times as wide. */
const MOST_SWITCHES = 4;

/** The target changes at this time, s. */
export function countSwitch(m: Motion, time: number): void {
  const { s } = m;
  s[SWITCHES] = time - s[SWITCH_TIME] <= m.sameInstant ? s[SWITCHES] + 1 : 1;
  s[SWITCH_TIME] = time;
}

/**
 * What counts as a tie, px. Where between fixed steps the way strays a little, each of two asteroids may seem to be nearer as soon as
 * the other is the target; and where the speed limit holds her along one axis, then along the other, nothing takes her away from there.
 */
function tieOf(m: Motion): number {
  const { s } = m;
  if (s[SWITCHES] <= MOST_SWITCHES || s[START] - s[SWITCH_TIME] > m.sameInstant) return TIE;
  // multiplied one by one: `**` may differ by a bit between JavaScript engines
  let tie = TIE;
  for (let n = MOST_SWITCHES; n < s[SWITCHES]; n++) tie = Math.min(WIDEST_TIE, 10 * tie);
  return tie;
}

/** What {@link switchGuard} says beside its value. */
const beside = new Float64Array(3);
/** Its slope; how fast that can fall at most; what the width of a tie makes of it. */
const SLOPE = 0;
const FALL = 1;
const TIED = 2;

const ix = new Float64Array(LONGEST_SERIES);
const iy = new Float64Array(LONGEST_SERIES);
const tx = new Float64Array(LONGEST_SERIES);
const ty = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/**
 * First time at which asteroid `i` is nearer than the target: a march of safe steps, after PATIENCE looks by the coefficients of
 * the guard, which is a polynomial. What it overlooks is a tie.
 * @param from s from the start of the piece
 * @param atZero both are as near, the target having just changed from this one
 * @returns s from the start of the piece, too; -1: not before it ends
 */
export function switchTime(m: Motion, i: number, from: number, atZero: boolean): number {
  const { s, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const small = smallestStride(s[LENGTH_H]);
  let t = from;
  let before = t;
  work.guards++;
  for (let n = 0; ; n++) {
    let g = switchGuard(m, i, t);
    // shallower than what the way itself may err by it is a tie, and the target stays
    if (g < -beside[TIED]) {
      if (n > 0) return switchBetween(m, i, before, t);
      if (!atZero && (beside[SLOPE] < 0 || g < -1e-9)) return t;
    }
    // within a tie the root may lie behind already
    if (g < 0) g = 0;
    else before = t;
    if (t >= horizon) return -1;
    const slope = beside[SLOPE];
    const above = g + beside[TIED];
    let step = safeStep(above, slope, beside[FALL]);
    if (n >= PATIENCE && t + step < horizon) {
      work.guards++;
      // where both are in the same place the slope at `t` is rounding alone, and the coefficients know that it is none
      const degree = switchSeries(m, i, t);
      step = Math.max(step, safeStretch(guard, degree, above, guard[1], 0, horizon - t));
    }
    if (!(t + step < horizon)) return -1;
    t = lookNext(t, step, small, horizon);
  }
}

/** The root by the polynomial about `before`: close to a tie there it has more digits than distances have. */
function switchBetween(m: Motion, i: number, before: number, behind: number): number {
  m.work.roots++;
  const value = Math.max(0, switchGuard(m, i, before));
  const degree = switchSeries(m, i, before);
  guard[0] = value;
  return crossing(before, behind, (t) => valueAt(guard, degree, t - before));
}

/** Into `guard` the coefficients of {@link switchGuard} about `t`; returns their degree. */
function switchSeries(m: Motion, i: number, t: number): number {
  const { s } = m;
  if (!m.recoil) {
    // both stand still, and the squares of her place fall out: 2 (target - i).u
    const mx = m.targetX[i] - m.targetX[s[TARGET]];
    const my = m.targetY[i] - m.targetY[s[TARGET]];
    for (let k = 0; k <= s[DEGREE]; k++) guard[k] = -2 * (mx * m.ux[k] + my * m.uy[k]);
    shift(guard, s[DEGREE], t);
    return s[DEGREE];
  }
  placeRock(m, s[TARGET]);
  const degree = relativeSeries(m, t, tx, ty);
  placeRock(m, i);
  const own = relativeSeries(m, t, ix, iy);
  const highest = Math.max(degree, own);
  for (let k = 0; k <= highest; k++) {
    const x = ix[k];
    const y = iy[k];
    ix[k] = x - tx[k];
    iy[k] = y - ty[k];
    tx[k] += x;
    ty[k] += y;
  }
  guard.fill(0);
  addProduct(ix, highest, tx, highest, 1, guard);
  addProduct(iy, highest, ty, highest, 1, guard);
  return 2 * highest;
}

/**
 * Squared distance to asteroid `i` minus that to the target, px2. Where both stand still it is linear in her place.
 * Its slope, a bound on how fast that can fall, and what the width of a tie makes of it go to {@link beside}.
 */
export function switchGuard(m: Motion, i: number, t: number): number {
  const { s, her, toCircle, budget } = m;
  if (++budget.looks > budget.most) budget.end();
  const target = s[TARGET];
  const a = s[ACCELERATION];
  const tie = tieOf(m);
  if (!m.recoil) {
    const ix = m.targetX[i] - s[BASE_X];
    const iy = m.targetY[i] - s[BASE_Y];
    const tx = m.targetX[target] - s[BASE_X];
    const ty = m.targetY[target] - s[BASE_Y];
    pairAt(m.ux, m.uy, s[DEGREE], t, her, 0);
    const mx = ix - tx;
    const my = iy - ty;
    beside[SLOPE] = -2 * (mx * her[2] + my * her[3]);
    const apart = Math.sqrt(mx * mx + my * my);
    beside[FALL] = 2 * a * apart;
    beside[TIED] = 2 * tie * apart;
    // (i - u)^2 - (t - u)^2 = (i - t).(i + t - 2 u)
    return mx * (ix + tx - 2 * her[0]) + my * (iy + ty - 2 * her[1]);
  }
  placeRock(m, target);
  relativeAt(m, t);
  const tx = toCircle[0];
  const ty = toCircle[1];
  const tvx = toCircle[2];
  const tvy = toCircle[3];
  placeRock(m, i);
  relativeAt(m, t);
  const left = s[LENGTH_H] - t;
  const pull = a + 2 * m.kappa;
  const fast = Math.sqrt(tvx * tvx + tvy * tvy) + pull * left;
  const far = Math.sqrt(toCircle[0] * toCircle[0] + toCircle[1] * toCircle[1]) + Math.sqrt(tx * tx + ty * ty) + 2 * fast * left;
  const g = (toCircle[0] - tx) * (toCircle[0] + tx) + (toCircle[1] - ty) * (toCircle[1] + ty);
  beside[SLOPE] = 2 * (toCircle[0] * toCircle[2] + toCircle[1] * toCircle[3] - tx * tvx - ty * tvy);
  beside[FALL] = 2 * fast * fast + 2 * far * pull;
  // nearer to each other than a tie is wide they are one, whatever rounding says
  beside[TIED] =
    2 * tie * Math.max(tie, Math.sqrt((toCircle[0] - tx) * (toCircle[0] - tx) + (toCircle[1] - ty) * (toCircle[1] - ty)));
  return g;
}

/** For how long, at most `time` s, asteroid `i` doesn't become the nearest, whatever the flow does. */
export function quietUntilSwitch(m: Motion, i: number, time: number): number {
  const g = switchGuard(m, i, 0) - SURPLUS;
  const mx = m.targetX[i] - m.targetX[m.s[TARGET]];
  const my = m.targetY[i] - m.targetY[m.s[TARGET]];
  const apart = Math.sqrt(mx * mx + my * my);
  return g > 0 ? Math.min(time, safeStep(g, beside[SLOPE], 2 * apart * m.strongest)) : 0;
}
