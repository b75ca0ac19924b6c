import { justFired, offer, rimTime } from '../events/index.ts';
import type { Circles } from '../indexed-circles.ts';
import { type EventRule, type Motion, placeCircle, relativeAt, SLOTS } from '../motion/index.ts';
import { LATEST_CROSSING, QUICK_CROSSING, SAME_RIM } from '../tolerances.ts';

/** Where her centre is: outside a circle or inside it, or on the very rim and moving inwards, which counts as inside at once. */
export const OUTSIDE = 0;
export const ENTERING = 1;
const INSIDE = 2;

/**
 * Where her centre is with respect to circle `i` (px in the level) at the start of the run, or where a jump has brought her.
 * What acts there acts from then on, so an exact touch at that time is judged with it.
 */
export function placeInCircle(m: Motion, { x, y, r }: Circles, i: number): number {
  const { s, ux, uy, px, py } = m;
  const dx = x[i] - m.originX - s[BASE_X] - ux[0];
  const dy = y[i] - m.originY - s[BASE_Y] - uy[0];
  const d2 = dx * dx + dy * dy;
  const r2 = r[i] * r[i];
  if (d2 !== r2) return d2 < r2 ? INSIDE : OUTSIDE;
  return dx * (ux[1] + px[1]) + dy * (uy[1] + py[1]) > 0 ? ENTERING : OUTSIDE;
}

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
function rimTolerance(m: Motion, x: number, y: number, r: number): number {
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

/**
 * Offers the time at which her centre crosses the rim of circle `i` (px in the level): leaving it if she is inside, otherwise
 * entering it.
 * @param enter - the kind of event for entering
 * @param leave - the kind of event for leaving
 * @param onWay - true if she crosses it only on her way: a place beyond the rim from which she moves back is one on it, and
 * fixed steps have put her there. Otherwise such a place is a crossing
 */
export function offerCrossing(
  m: Motion,
  { x, y, r }: Circles,
  i: number,
  isInside: boolean,
  enter: EventRule,
  leave: EventRule,
  from: number,
  onWay: boolean,
): void {
  const { kind } = isInside ? leave : enter;
  placeCircle(m, x[i], y[i], m.originX, m.originY);
  const late = rimTolerance(m, x[i], y[i], r[i]);
  const isOnRim = justFired(m, kind, i) || (onWay && movesBack(m, isInside, from));
  offer(m, rimTime(m, r[i] + (isInside ? late : -late), !isInside, 0, from, isOnRim), kind, i, 0);
}

/** Whether she moves to the side of the placed circle's rim on which she counts. */
function movesBack(m: Motion, isInside: boolean, from: number): boolean {
  const { toCircle } = m;
  relativeAt(m, from);
  const outwards = toCircle[0] * toCircle[2] + toCircle[1] * toCircle[3];
  return isInside ? outwards < 0 : outwards > 0;
}
