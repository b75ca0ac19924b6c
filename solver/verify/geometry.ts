import type { Box } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';

/**
 * A margin for comparisons that rounding cannot falsify. Lengths in levels are below 1e10 px and doubles have 16 digits, so
 * sums and roots of a few of them have relative errors below 1e-12. A margin of 1e-10 of the lengths, and of at least 1e-7 px,
 * leaves much room.
 */
const margin = (a: number, b: number): number => 1e-7 + 1e-10 * (Math.abs(a) + Math.abs(b));

/** Whether a is certainly less than b. False for NaN. */
export const less = (a: number, b: number): boolean => a < b - margin(a, b);

/** Where she starts: places of a claim are relative to it. */
export const START: Place = { x: 0, y: 0 };

/** Distance between two places, px. */
export const apart = (a: Place, b: Place): number => Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));

/** Whether a value is an index into a list. */
export const isIndex = (value: unknown, list: readonly unknown[]): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 && value < list.length;

/**
 * Distance between her box and a circle, px; negative where they overlap, but not below minus the radius.
 * @param side the direction of the box's x axis, a unit vector
 */
export function boxGap({ halfWidth, halfHeight }: Box, centre: Place, side: Place, circle: Disc): number {
  const dx = circle.x - centre.x;
  const dy = circle.y - centre.y;
  const along = Math.max(0, Math.abs(dx * side.x + dy * side.y) - halfWidth);
  const across = Math.max(0, Math.abs(dy * side.x - dx * side.y) - halfHeight);
  return Math.sqrt(along * along + across * across) - circle.radius;
}

/** A vector divided by its length. */
export const unit = ({ x, y }: Place): Place => {
  const length = Math.sqrt(x * x + y * y);
  return { x: x / length, y: y / length };
};
