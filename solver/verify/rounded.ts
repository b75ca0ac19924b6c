/**
 * Comparisons that rounding can't fool. Lengths of levels are below 1e10 px and a double has 16 digits, so sums and roots
 * of a few of them err by less than 1e-12 of their size; a margin of 1e-9 of it, and 1e-7 px at least, leaves much room.
 */
const margin = (a: number, b: number): number => 1e-7 + 1e-10 * (Math.abs(a) + Math.abs(b));

/** Whether a is less than b for certain. False for NaN, whatever the other is. */
export const less = (a: number, b: number): boolean => a < b - margin(a, b);

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Distance between two places, px. */
export const apart = (a: Point, b: Point): number => Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));

/** Whether a value is the index of something in a list. */
export const isIndex = (value: unknown, list: readonly unknown[]): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 && value < list.length;
