import { bisect } from '../bracket.ts';
import { placeRock, relativeAt } from '../circle.ts';
import { justFired } from '../first-event.ts';
import { safeStep, smallestStride } from '../march.ts';
import type { Motion } from '../motion.ts';
import { pairAt } from '../polynomial.ts';
import { EVENTS, SLOTS } from '../state.ts';

const { TARGET, BASE_X, BASE_Y, DEGREE, LENGTH_H, ACCELERATION } = SLOTS;
const { SWITCH } = EVENTS;

/** A dip across the bisector of two asteroids shallower than this is within the error of the way: no change of target, px. */
const TIE = 1e-11;

/**
 * First time at which asteroid `i` is nearer than the target.
 * @param from s from the start of the piece
 * @returns s from there, too; -1: not before the piece ends
 */
export function switchTime(m: Motion, i: number, from: number): number {
  const { s, e, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const atZero = justFired(m, SWITCH, i);
  let small = smallestStride(s[LENGTH_H]);
  let t = from;
  let before = t;
  work.guards++;
  for (let n = 0; ; n++) {
    let g = switchGuard(m, i, t);
    // shallower than what the way itself may err by it is a tie, and the target stays
    if (g < -e[11]) {
      if (n > 0) return switchBetween(m, i, before, t);
      if (!atZero && (e[9] < 0 || g < -1e-9)) return t;
    }
    if (g < 0) g = 0;
    if (t >= horizon) return -1;
    // e[9]: slope, e[10]: how fast it may fall
    const step = safeStep(g, e[9], e[10]);
    if (!(t + step < horizon)) return -1;
    if (n > 400) small *= 2;
    before = t;
    t = Math.min(horizon, t + Math.max(step, small));
  }
}

function switchBetween(m: Motion, i: number, before: number, behind: number): number {
  m.work.roots++;
  return bisect(before, behind, (t) => switchGuard(m, i, t) < 0);
}

/**
 * Squared distance to asteroid `i` minus that to the target, px2. Where both stand still it is linear in her place.
 * e[9]: its slope; e[10]: a bound on how fast the slope can fall; e[11]: what TIE px across the bisector make of it.
 */
export function switchGuard(m: Motion, i: number, t: number): number {
  const { s, e, budget } = m;
  if (++budget.looks > budget.most) budget.end();
  const target = s[TARGET];
  const a = s[ACCELERATION];
  if (!m.recoil) {
    const ix = m.targetX[i] - s[BASE_X];
    const iy = m.targetY[i] - s[BASE_Y];
    const tx = m.targetX[target] - s[BASE_X];
    const ty = m.targetY[target] - s[BASE_Y];
    pairAt(m.ux, m.uy, s[DEGREE], t, e, 0);
    const mx = ix - tx;
    const my = iy - ty;
    e[9] = -2 * (mx * e[2] + my * e[3]);
    const apart = Math.sqrt(mx * mx + my * my);
    e[10] = 2 * a * apart;
    e[11] = 2 * TIE * apart;
    // (i - u)^2 - (t - u)^2 = (i - t).(i + t - 2 u)
    return mx * (ix + tx - 2 * e[0]) + my * (iy + ty - 2 * e[1]);
  }
  placeRock(m, target);
  relativeAt(m, t);
  const tx = e[4];
  const ty = e[5];
  const tvx = e[6];
  const tvy = e[7];
  placeRock(m, i);
  relativeAt(m, t);
  const slope = 2 * (e[4] * e[6] + e[5] * e[7] - tx * tvx - ty * tvy);
  const left = s[LENGTH_H] - t;
  const pull = a + 2 * m.kappa;
  const fast = Math.sqrt(tvx * tvx + tvy * tvy) + pull * left;
  const far = Math.sqrt(e[4] * e[4] + e[5] * e[5]) + Math.sqrt(tx * tx + ty * ty) + 2 * fast * left;
  const g = (e[4] - tx) * (e[4] + tx) + (e[5] - ty) * (e[5] + ty);
  e[9] = slope;
  e[10] = 2 * fast * fast + 2 * far * pull;
  e[11] = 2 * TIE * Math.sqrt((e[4] - tx) * (e[4] - tx) + (e[5] - ty) * (e[5] - ty));
  return g;
}
