import { eventRule, justFired, offer } from '../../events/index.ts';
import { GOES_ON, type Motion, SLOTS } from '../../motion/index.ts';
import { CUBIC_BENDS } from '../../tolerances.ts';
import type { Effect } from '../effect.ts';
import { freeTime, limitTime } from './guard.ts';

const { LIMIT_X, LIMIT_Y, LENGTH_H, ACCELERATION, LAST_EVENT, LAST_A } = SLOTS;

/**
 * An axis of her velocity reaches the limit. It is held there while the force would drive it further. Two guards are needed,
 * both of them polynomials: the velocity along the axis, and her place along it, since a central force changes its sign along
 * an axis where she passes the centre.
 */
const holdAxis = eventRule({
  name: 'limit',
  always(m, from) {
    const { s, path } = m;
    const fast = path.speed + (s[ACCELERATION] + m.kappa) * s[LENGTH_H] >= m.rules.speedLimit;
    if (!fast && s[LIMIT_X] === 0 && s[LIMIT_Y] === 0) return;
    for (let axis = 0; axis < 2; axis++) {
      const held = s[axis === 0 ? LIMIT_X : LIMIT_Y];
      if (held !== 0) {
        offer(m, freeTime(m, axis, held, from), freeAxis.kind, axis, 0);
        continue;
      }
      const released = justFired(m, holdAxis.kind, axis);
      for (let sign = -1; sign <= 1; sign += 2) {
        offer(m, limitTime(m, axis, sign, from, released), holdAxis.kind, axis, sign);
      }
    }
  },
  alwaysQuiet(m, time) {
    const { s, path } = m;
    const below = m.rules.speedLimit - path.speed;
    if (s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0 || !(below > 0)) return 0;
    // between its ends a fixed step may bend more than the strongest force
    return Math.min(time, below / (CUBIC_BENDS * path.strongest));
  },
  fire(m, axis, sign) {
    m.s[axis === 0 ? LIMIT_X : LIMIT_Y] = sign;
    holdLimits(m);
    return GOES_ON;
  },
});

/** The force drives an axis of her velocity back from the limit. */
const freeAxis = eventRule({
  name: 'unlimit',
  fire(m, axis) {
    const { s } = m;
    s[LAST_EVENT] = holdAxis.kind;
    s[LAST_A] = axis;
    s[axis === 0 ? LIMIT_X : LIMIT_Y] = 0;
    return GOES_ON;
  },
});

/** Keeps a limited axis at exactly the limit. */
function holdLimits(m: Motion): void {
  const { s, ux, uy, px, py } = m;
  if (s[LIMIT_X] !== 0) ux[1] = s[LIMIT_X] * m.rules.speedLimit - px[1];
  if (s[LIMIT_Y] !== 0) uy[1] = s[LIMIT_Y] * m.rules.speedLimit - py[1];
}

/** Holds axes that are at the limit from the start. */
function limitStart(m: Motion): void {
  const limit = (v: number) => (v >= m.rules.speedLimit ? 1 : v <= -m.rules.speedLimit ? -1 : 0);
  m.s[LIMIT_X] = limit(m.ux[1]);
  m.s[LIMIT_Y] = limit(m.uy[1]);
}

export const speedLimit: Effect = {
  name: 'speed-limit',
  summary: (rules) => `each component of a velocity stays within ${rules.speedLimit} px/s`,
  calledFor: () => ({ called: true, because: 'a long run may reach it' }),
  rules: ['speedLimit'],
  events: [holdAxis, freeAxis],
  layOut: limitStart,
};
