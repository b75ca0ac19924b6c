import type { Box } from './box.ts';

/**
 * Tells whether the collision box overlaps a circle. Touching is no overlap.
 *
 * The circle's centre is turned into the box's frame and clamped to the box; the distance from the clamped point is compared
 * with the radius. This is `collidesRectCircle` of the original game.
 *
 * @param box - the collision box
 * @param dx - x of the circle's centre minus x of the box's centre, px
 * @param dy - y of the circle's centre minus y of the box's centre, px
 * @param cos - x of the direction of the box's x axis, a unit vector
 * @param sin - y of that direction
 * @param r - radius of the circle, px
 * @returns whether they overlap
 */
export function boxOverlapsCircle(box: Box, dx: number, dy: number, cos: number, sin: number, r: number): boolean {
  const reach = box.halfDiagonal + r;
  if (dx > reach || dx < -reach || dy > reach || dy < -reach) return false;
  const gx = Math.abs(dx * cos + dy * sin) - box.halfWidth;
  const gy = Math.abs(dy * cos - dx * sin) - box.halfHeight;
  if (gx <= 0) return gy < r;
  if (gy <= 0) return gx < r;
  return gx * gx + gy * gy < r * r;
}

/**
 * The gap between the collision box and a circle.
 *
 * @param box - the collision box
 * @param dx - x of the circle's centre minus x of the box's centre, px
 * @param dy - y of the circle's centre minus y of the box's centre, px
 * @param cos - x of the direction of the box's x axis, a unit vector
 * @param sin - y of that direction
 * @param r - radius of the circle, px
 * @returns the distance between their edges, px; negative where they overlap, and at least -r
 */
export function boxCircleGap(box: Box, dx: number, dy: number, cos: number, sin: number, r: number): number {
  const gx = Math.abs(dx * cos + dy * sin) - box.halfWidth;
  const gy = Math.abs(dy * cos - dx * sin) - box.halfHeight;
  if (gx <= 0 && gy <= 0) return -r;
  if (gx <= 0) return gy - r;
  if (gy <= 0) return gx - r;
  return Math.sqrt(gx * gx + gy * gy) - r;
}
