import { DEFAULT_RULES, type Rules } from '../schema/basics/index.ts';

/** The astronaut's collision box. Its x axis points at the target. */
export interface Box {
  /** Half its side along its x axis, px. */
  readonly halfWidth: number;
  /** Half its side across, px. */
  readonly halfHeight: number;
  /** Half its diagonal, px, rounded up. It serves as a bound: a larger value would also be right, only slower. */
  readonly halfDiagonal: number;
}

/**
 * The collision box under given rules.
 *
 * @param rules - the game's rules; `boxWidth` and `boxHeight` are used, px
 * @returns the box
 */
export function boxOf({ boxWidth, boxHeight }: Rules): Box {
  const halfWidth = boxWidth / 2;
  const halfHeight = boxHeight / 2;
  const halfDiagonal = Math.ceil(Math.sqrt(halfWidth * halfWidth + halfHeight * halfHeight) * 1000 + 1e-6) / 1000;
  return { halfWidth, halfHeight, halfDiagonal };
}

/** The original game's box: 20 x 32 px. */
export const DEFAULT_BOX: Box = boxOf(DEFAULT_RULES);

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

/**
 * Tells whether two circles overlap. Touching from outside is no overlap. This is `collidesCircleCircle` of the original game.
 *
 * @param dx - x of the second centre minus x of the first, px
 * @param dy - y of the second centre minus y of the first, px
 * @param reach - sum of both radii, px
 * @returns whether they overlap
 */
export function circlesOverlap(dx: number, dy: number, reach: number): boolean {
  return dx * dx + dy * dy < reach * reach;
}
