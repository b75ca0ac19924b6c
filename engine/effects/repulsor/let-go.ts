import { crossing, lookNext } from '../../events/index.ts';
import { type Motion, SLOTS } from '../../motion/index.ts';
import { SHORTEST_LAPSE } from '../../tolerances.ts';
import { weighAt } from './come-off.ts';

const { LIMIT_X, LIMIT_Y, LENGTH_H, ACCELERATION } = SLOTS;

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
  const { s, her, toTarget, rim, work } = m;
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
    // bounds of distance and speeds as in come-off.ts
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
  const { s, her, rim } = m;
  const { freeX, freeY } = rim;
  rim.freeX = rim.freeY = true;
  weighAt(m, t);
  rim.accelerate(her[0], her[1], acceleration, 0);
  rim.freeX = freeX;
  rim.freeY = freeY;
  return s[axis === 0 ? LIMIT_X : LIMIT_Y] * acceleration[axis];
}
