import type { Circles } from '../../indexed-circles.ts';
import { type Motion, SLOTS } from '../../motion/index.ts';

const { BASE_X, BASE_Y } = SLOTS;

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
