import { CENTRAL, LINEAR, type Motion, SLOTS, TURNS } from '../../motion/index.ts';
import { holdOnLine } from './meeting.ts';

const { HELD, FIELD, KIND, TURN, COS, SIN, SIDE, LINE_X, LINE_Y } = SLOTS;
const { TURN_TO_BASE, TURN_TO_TARGET } = TURNS;

/** Sets how the box turns: while the gun is held it points at the target. */
export function turnToTarget(m: Motion): void {
  const { s } = m;
  if (s[HELD] === 0) return;
  if (s[FIELD] >= 0) {
    if (!holdOnLine(m)) s[TURN] = TURN_TO_TARGET;
    return;
  }
  if (s[KIND] === CENTRAL) s[TURN] = TURN_TO_BASE;
  if (s[KIND] !== LINEAR) return;
  s[COS] = -s[SIDE] * s[LINE_X];
  s[SIN] = -s[SIDE] * s[LINE_Y];
}
