import type { Circles } from '../../circles.ts';
import { justFired, offer, rimTime } from '../../events/index.ts';
import { type EventRule, type Motion, placeCircle } from '../../motion/index.ts';
import { rimTolerance } from './chatter.ts';

/**
 * Offers the time at which her centre crosses the rim of circle `i` (px in the level): leaving it if she is inside, otherwise
 * entering it.
 * @param enter - the kind of event for entering
 * @param leave - the kind of event for leaving
 */
export function offerCrossing(
  m: Motion,
  { x, y, r }: Circles,
  i: number,
  isInside: boolean,
  enter: EventRule,
  leave: EventRule,
  from: number,
): void {
  const { kind } = isInside ? leave : enter;
  placeCircle(m, x[i], y[i], m.originX, m.originY);
  const late = rimTolerance(m, x[i], y[i], r[i]);
  offer(m, rimTime(m, r[i] + (isInside ? late : -late), !isInside, 0, from, justFired(m, kind, i)), kind, i, 0);
}
