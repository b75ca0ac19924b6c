import type { Box } from '../../engine/index.ts';
import type { Point } from './rounded.ts';

export type Circle = Point & { readonly radius: number };

/**
 * Distance between her box and a circle, px; negative where they overlap, but not below minus the radius.
 * @param side the direction of the box's x axis, a unit vector
 */
export function boxGap({ halfWidth, halfHeight }: Box, centre: Point, side: Point, circle: Circle): number {
  const dx = circle.x - centre.x;
  const dy = circle.y - centre.y;
  const along = Math.max(0, Math.abs(dx * side.x + dy * side.y) - halfWidth);
  const across = Math.max(0, Math.abs(dy * side.x - dx * side.y) - halfHeight);
  return Math.sqrt(along * along + across * across) - circle.radius;
}

/** A vector divided by its length. */
export const unit = ({ x, y }: Point): Point => {
  const length = Math.sqrt(x * x + y * y);
  return { x: x / length, y: y / length };
};
