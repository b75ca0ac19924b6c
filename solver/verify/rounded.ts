/**
 * A margin for comparisons that rounding cannot falsify. Lengths in levels are below 1e10 px and doubles have 16 digits, so
 * sums and roots of a few of them have relative errors below 1e-12. A margin of 1e-10 of the lengths, and of at least 1e-7 px,
 * leaves much room.
 */
const margin = (a: number, b: number): number => 1e-7 + 1e-10 * (Math.abs(a) + Math.abs(b));

/** Whether a is certainly less than b. False for NaN. */
export const less = (a: number, b: number): boolean => a < b - margin(a, b);

/** A place, px. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Distance between two places, px. */
export const apart = (a: Point, b: Point): number => Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));

/** Whether a value is an index into a list. */
export const isIndex = (value: unknown, list: readonly unknown[]): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 && value < list.length;
