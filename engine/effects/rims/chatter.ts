import { type Motion, SLOTS } from '../../motion/index.ts';
import { LATEST_CROSSING, QUICK_CROSSING, SAME_RIM } from '../../tolerances.ts';

const { BASE_X, BASE_Y, RIM, RIM_TIME, CHATTER } = SLOTS;

/** The count of a chatter is limited to this many crossings. */
const MOST = 15;

/** Upper bound of the rounding error of a place on the rim of a circle, px. */
export function roundingOnRim(m: Motion, x: number, y: number, r: number): number {
  const { s } = m;
  const far = Math.abs(x - m.originX) + Math.abs(y - m.originY) + Math.abs(s[BASE_X]) + Math.abs(s[BASE_Y]);
  return 1e-13 + 1e-14 * (far + r);
}

/** More crossings in quick succession than this are a chatter; each further one doubles how late a rim is crossed. */
const CHATTERS = 8;

/**
 * How far beyond a rim she is when it counts as crossed, px; normally 0. While she slides along one rim, others that almost
 * coincide with it must not be crossed again and again. Where she chatters between rims that meet, she swings wider and wider,
 * until the crossings are no more frequent than can be simulated in reasonable time.
 */
export function rimTolerance(m: Motion, x: number, y: number, r: number): number {
  const { s } = m;
  if (s[RIM] < 0 && s[CHATTER] <= CHATTERS) return 0;
  let far = SAME_RIM;
  for (let n = CHATTERS; n < s[CHATTER]; n++) far = Math.min(LATEST_CROSSING, 2 * far);
  return far + roundingOnRim(m, x, y, r);
}

/** Counts crossings of rims in quick succession: where several rims meet she may be thrown back and forth endlessly. */
export function countCrossing(m: Motion, time: number): void {
  const { s } = m;
  s[CHATTER] = time - s[RIM_TIME] < QUICK_CROSSING ? Math.min(MOST, s[CHATTER] + 1) : Math.max(0, s[CHATTER] - 1);
  s[RIM_TIME] = time;
}
