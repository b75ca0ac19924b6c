import { justFired, offer, rimTime } from '../../events/index.ts';
import type { Circles } from '../../indexed-circles.ts';
import { type EventRule, type Motion, placeCircle, relativeAt } from '../../motion/index.ts';
import { rimTolerance } from './chatter.ts';

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
