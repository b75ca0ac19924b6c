import { crossing, lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from '../../events/index.ts';
import {
  addProduct,
  LONGEST_SERIES,
  type Motion,
  nearest,
  pairAt,
  placeRock,
  relativeAt,
  relativeSeries,
  SLOTS,
  shift,
  valueAt,
} from '../../motion/index.ts';
import { SURPLUS, TIE, WIDEST_TIE } from '../../tolerances.ts';

const { HELD, TARGET, COVER, START, BASE_X, BASE_Y, DEGREE, LENGTH_H, ACCELERATION, SWITCH_TIME, SWITCHES } = SLOTS;

/** Reports to the recorder which asteroid is the target from now on. */
export function recordTarget(m: Motion, time: number): void {
  m.recorder?.event({ time, type: 'target', index: m.scene.targets.index[m.s[TARGET]] });
}

/** Chooses the target anew after she was moved: another asteroid may be the nearest. */
export function holdNearest(m: Motion, time: number): void {
  const { s } = m;
  if (s[HELD] === 0) return;
  const before = s[TARGET];
  s[TARGET] = nearest(m);
  s[COVER] = s[TARGET];
  if (s[TARGET] !== before) recordTarget(m, time);
}

/** This many changes of target in one instant are normal; each further one makes a tie ten times as wide. */
const MOST_SWITCHES = 4;

/** Counts a change of target at this time, s. */
export function countSwitch(m: Motion, time: number): void {
  const { s } = m;
  s[SWITCHES] = time - s[SWITCH_TIME] <= m.sameInstant ? s[SWITCHES] + 1 : 1;
  s[SWITCH_TIME] = time;
}

/**
 * The width of a tie, px. It must grow in two cases. Between fixed steps the path errs a little, so that each of two asteroids
 * may seem nearer as soon as the other is the target. And where the speed limit holds her along one axis and then the other,
 * nothing takes her away.
 */
function tieOf(m: Motion): number {
  const { s } = m;
  if (s[SWITCHES] <= MOST_SWITCHES || s[START] - s[SWITCH_TIME] > m.sameInstant) return TIE;
  // multiplied step by step: `**` may differ by a bit between JavaScript engines
  let tie = TIE;
  for (let n = MOST_SWITCHES; n < s[SWITCHES]; n++) tie = Math.min(WIDEST_TIE, 10 * tie);
  return tie;
}

/** What {@link switchGuard} returns besides its value. */
const beside = new Float64Array(3);
/** Its slope; a bound of how fast the slope can fall; and the value that the width of a tie corresponds to. */
const SLOPE = 0;
const FALL = 1;
const TIED = 2;

const ix = new Float64Array(LONGEST_SERIES);
const iy = new Float64Array(LONGEST_SERIES);
const tx = new Float64Array(LONGEST_SERIES);
const ty = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/**
 * First time at which asteroid `i` is nearer than the target: a march of safe steps, which after PATIENCE evaluations continues
 * by the coefficients of the guard, a polynomial. It can overlook only a tie.
 * @param from - where to begin, s after the start of the piece
 * @param atZero - both are equally near, the target having just changed from this asteroid
 * @returns s after the start of the piece; -1 if not before the piece ends
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
    // a dip shallower than the error of the path is a tie, and the target stays
    if (g < -beside[TIED]) {
      if (n > 0) return switchBetween(m, i, before, t);
      if (!atZero && (beside[SLOPE] < 0 || g < -1e-9)) return t;
    }
    // within a tie the root may lie in the past
    if (g < 0) g = 0;
    else before = t;
    if (t >= horizon) return -1;
    const slope = beside[SLOPE];
    const above = g + beside[TIED];
    let step = safeStep(above, slope, beside[FALL]);
    if (n >= PATIENCE && t + step < horizon) {
      work.guards++;
      // if both are in the same place, the slope at `t` is only rounding, and the coefficients show that it is 0
      const degree = switchSeries(m, i, t);
      step = Math.max(step, safeStretch(guard, degree, above, guard[1], 0, horizon - t));
    }
    if (!(t + step < horizon)) return -1;
    t = lookNext(t, step, small, horizon);
  }
}

/** The root of the polynomial about `before`: close to a tie it has more digits than distances have. */
function switchBetween(m: Motion, i: number, before: number, behind: number): number {
  m.work.roots++;
  const value = Math.max(0, switchGuard(m, i, before));
  const degree = switchSeries(m, i, before);
  guard[0] = value;
  return crossing(before, behind, (t) => valueAt(guard, degree, t - before));
}

/** Writes the coefficients of {@link switchGuard} about `t` to `guard`; returns their degree. */
function switchSeries(m: Motion, i: number, t: number): number {
  const { s } = m;
  if (!m.recoil) {
    // both stand still, and the squares of her place cancel: 2 (target - i).u
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
 * Squared distance to asteroid `i` minus that to the target, px². If both stand still it is linear in her place. Its slope, a
 * bound of how fast that can fall, and the width of a tie go to {@link beside}.
 */
function switchGuard(m: Motion, i: number, t: number): number {
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
  // asteroids nearer to each other than a tie is wide count as one, whatever rounding says
  beside[TIED] =
    2 * tie * Math.max(tie, Math.sqrt((toCircle[0] - tx) * (toCircle[0] - tx) + (toCircle[1] - ty) * (toCircle[1] - ty)));
  return g;
}

/** For how long, at most `time` s, asteroid `i` cannot become the nearest, whatever the flow does. */
export function quietUntilSwitch(m: Motion, i: number, time: number): number {
  const g = switchGuard(m, i, 0) - SURPLUS;
  const mx = m.targetX[i] - m.targetX[m.s[TARGET]];
  const my = m.targetY[i] - m.targetY[m.s[TARGET]];
  const apart = Math.sqrt(mx * mx + my * my);
  return g > 0 ? Math.min(time, safeStep(g, beside[SLOPE] - 2 * apart * m.path.lead, 2 * apart * m.path.strongest)) : 0;
}
