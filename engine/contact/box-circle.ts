import type { Box } from './box.ts';

/**
 * Whether the astronaut's box overlaps a circle: the circle's centre is turned into the box's frame, clamped to the
 * box, and the distance from the clamped point compared with r (equal is no contact). The original's `collidesRectCircle`.
 * @param dx, dy circle's centre minus the box's centre, px
 * @param cos, sin direction of the box's x axis, a unit vector
 * @param r radius of the circle, px
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
 * Gap between the astronaut's box and a circle, px: negative by at most r when they overlap.
 * Arguments as in {@link boxOverlapsCircle}.
 */
export function boxCircleGap(box: Box, dx: number, dy: number, cos: number, sin: number, r: number): number {
  const gx = Math.abs(dx * cos + dy * sin) - box.halfWidth;
  const gy = Math.abs(dy * cos - dx * sin) - box.halfHeight;
  if (gx <= 0 && gy <= 0) return -r;
  if (gx <= 0) return gy - r;
  if (gy <= 0) return gx - r;
  return Math.sqrt(gx * gx + gy * gy) - r;
}
