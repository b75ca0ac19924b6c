import { type Motion, SLOTS } from '../../motion/index.ts';
import { LATEST_CROSSING, QUICK_CROSSING, SAME_RIM } from '../../tolerances.ts';

const { BASE_X, BASE_Y, RIM, RIM_TIME, CHATTER } = SLOTS;

/** A chatter at most so many crossings ahead is kept in mind. */
const MOST = 15;

/** What rounding makes of a place on the rim of a circle, px, with room. */
export function roundingOnRim(m: Motion, x: number, y: number, r: number): number {
  const { s } = m;
  const far = Math.abs(x - m.originX) + Math.abs(y - m.originY) + Math.abs(s[BASE_X]) + Math.abs(s[BASE_Y]);
  return 1e-13 + 1e-14 * (far + r);
}

/** So many crossings in quick succession are a chatter; with each one more a rim is crossed twice as late. */
const CHATTERS = 8;

/**
 * How far beyond a rim she is when it counts as crossed, px: 0 as a rule. While she slides along one rim, others that all but
 * coincide with it are not to be crossed again and again; where she chatters between rims that meet, she is let swing wider
 * until the crossings come no faster than anybody could wait for.
 */
export function rimTolerance(m: Motion, x: number, y: number, r: number): number {
  const { s } = m;
  if (s[RIM] < 0 && s[CHATTER] <= CHATTERS) return 0;
  let far = SAME_RIM;
  for (let n = CHATTERS; n < s[CHATTER]; n++) far = Math.min(LATEST_CROSSING, 2 * far);
  return far + roundingOnRim(m, x, y, r);
}

/** Keeps count of crossings of rims in quick succession: where several rims meet she may be thrown to and fro without end. */
export function countCrossing(m: Motion, time: number): void {
  const { s } = m;
  s[CHATTER] = time - s[RIM_TIME] < QUICK_CROSSING ? Math.min(MOST, s[CHATTER] + 1) : Math.max(0, s[CHATTER] - 1);
  s[RIM_TIME] = time;
}
