import { bisect } from '../bracket.ts';
import { relativeAt } from '../circle.ts';
import { safeStep, smallestStride } from '../march.ts';
import type { Motion } from '../motion.ts';
import { SLOTS } from '../state.ts';

const { LENGTH_H, ACCELERATION } = SLOTS;

/**
 * First time at which her centre crosses the rim of the placed circle.
 * @param r its radius, px
 * @param inward entering it; otherwise leaving
 * @param pull bound on the circle's own acceleration, px/s2
 * @param from s from the start of the piece
 * @param atZero she stands on the rim, having just crossed it the other way
 * @returns s from the start of the piece; -1: not before it ends
 */
export function rimTime(m: Motion, r: number, inward: boolean, pull: number, from: number, atZero: boolean): number {
  const { s, e, work } = m;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const a = s[ACCELERATION] + m.kappa + pull;
  const sign = inward ? 1 : -1;
  let small = smallestStride(s[LENGTH_H]);
  let t = from;
  let before = t;
  work.guards++;
  for (let n = 0; ; n++) {
    relativeAt(m, t);
    const d2 = e[4] * e[4] + e[5] * e[5];
    const d = Math.sqrt(d2);
    // (d - r)(d + r): the difference of squares would lose the digits of d - r
    let g = sign * (d - r) * (d + r);
    const slope = sign * 2 * (e[4] * e[6] + e[5] * e[7]);
    if (g < 0) {
      if (n > 0) return rimBetween(m, before, t, r, sign);
      if (!atZero && g < -1e-12 * r * r) return t;
      if (slope < 0 && !atZero) return t;
      g = 0;
    }
    if (t >= horizon) return -1;
    const left = horizon - t;
    const v = Math.sqrt(e[6] * e[6] + e[7] * e[7]);
    // g'' = sign (2 v^2 + 2 d.a); with a force the bound holds for `cap` only
    let cap = left;
    let k = inward ? 0 : 2 * v * v;
    if (a > 0) {
      cap = Math.min(left, v / a + Math.sqrt(d / a) + 1e-3);
      const fast = v + a * cap;
      k = 2 * (d + fast * cap) * a + (inward ? 0 : 2 * fast * fast);
    }
    const step = Math.min(cap, safeStep(g, slope, k));
    if (!(t + step < horizon)) return -1;
    if (n > 400) small *= 2;
    before = t;
    t = Math.min(horizon, t + Math.max(step, small));
  }
}

function rimBetween(m: Motion, before: number, behind: number, r: number, sign: number): number {
  const { e } = m;
  m.work.roots++;
  return bisect(before, behind, (t) => {
    relativeAt(m, t);
    return sign * (Math.sqrt(e[4] * e[4] + e[5] * e[5]) - r) < 0;
  });
}
