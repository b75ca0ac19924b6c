/**
 * Every bound is rounded outwards by this many px, and by {@link RELATIVE} of the lengths in it: far more than the rounding
 * errors of doubles.
 */
const ABSOLUTE = 1e-6;
const RELATIVE = 1e-9;

/** The least difference by which two lengths count as different, px. */
export const margin = (a: number, b: number): number => ABSOLUTE + RELATIVE * (Math.abs(a) + Math.abs(b));

/** Whether a length is less than another by more than rounding can explain. */
export const surelyLess = (a: number, b: number): boolean => a < b - margin(a, b);

/** Distance between two places, px. */
export function distance(a: { readonly x: number; readonly y: number }, b: { readonly x: number; readonly y: number }): number {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}
