import { SPEED_LIMIT } from '../../constants.ts';
import { bisect } from '../bracket.ts';
import { justFired, offer } from '../first-event.ts';
import { COAST } from '../flow.ts';
import type { Motion } from '../motion.ts';
import { placeAt } from '../places.ts';
import { EVENTS, SLOTS } from '../state.ts';

const { LIMIT_X, LIMIT_Y, LENGTH_H } = SLOTS;
const { LIMIT, UNLIMIT } = EVENTS;

/** The speed limit: each axis is held at it while the force would drive it on. */
export function considerLimits(m: Motion, from: number): void {
  const { s } = m;
  for (let axis = 0; axis < 2; axis++) {
    const held = s[axis === 0 ? LIMIT_X : LIMIT_Y];
    if (held !== 0) {
      const time = limitRoot(m, from, (t) => held * forceAt(m, axis, t));
      offer(m, time, UNLIMIT, axis, 0);
      continue;
    }
    for (let sign = -1; sign <= 1; sign += 2) {
      if (justFired(m, LIMIT, axis) && from === 0 && sign * forceAt(m, axis, 0) <= 0) continue;
      const time = limitRoot(m, from, (t) => SPEED_LIMIT - sign * velocityAt(m, axis, t));
      offer(m, time, LIMIT, axis, sign);
    }
  }
}

function velocityAt(m: Motion, axis: number, t: number): number {
  placeAt(m, t);
  return m.e[2 + axis] + (m.recoil ? m.e[6 + axis] : 0);
}

/** The acceleration along an axis that the limit does not hold back, px/s2. */
function forceAt(m: Motion, axis: number, t: number): number {
  const { flow, e } = m;
  if (flow.kind === COAST) return 0;
  placeAt(m, t);
  const { freeX, freeY } = flow;
  flow.freeX = true;
  flow.freeY = true;
  flow.accelerate(e[0], e[1], e, 8);
  flow.freeX = freeX;
  flow.freeY = freeY;
  return e[8 + axis];
}

/** First time `guard` falls below 0: it is smooth and the piece short, so a scan in 16 parts brackets the root. */
function limitRoot(m: Motion, from: number, guard: (t: number) => number): number {
  const { s } = m;
  const h = Math.min(m.horizon, s[LENGTH_H]);
  if (!Number.isFinite(h)) return guard(from) < 0 ? from : -1;
  m.work.guards++;
  if (guard(from) < 0) return from;
  let a = from;
  for (let n = 1; n <= 16; n++) {
    const b = from + ((h - from) * n) / 16;
    if (guard(b) >= 0) {
      a = b;
      continue;
    }
    m.work.roots++;
    return bisect(a, b, (t) => guard(t) < 0);
  }
  return -1;
}
