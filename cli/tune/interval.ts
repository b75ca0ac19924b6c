/** The precision of a threshold, as a share of the level's value. */
const PRECISION = 1e-3;

/** An interval of values that work, and whether each end is a real bound. */
export interface Interval {
  readonly low: number;
  readonly high: number;
  readonly isLowBound: boolean;
  readonly isHighBound: boolean;
}

/** Goes from a value that works through the others to the first that fails, then narrows the threshold by bisection. */
function follow(own: number, others: readonly number[], works: (value: number) => boolean): { end: number; isBound: boolean } {
  let good = own;
  for (const value of others) {
    if (works(value)) {
      good = value;
      continue;
    }
    const precision = PRECISION * (own === 0 ? Math.abs(value) : Math.abs(own));
    for (let bad = value; Math.abs(bad - good) > precision; ) {
      const middle = (good + bad) / 2;
      if (works(middle)) good = middle;
      else bad = middle;
    }
    return { end: good, isBound: true };
  }
  return { end: good, isBound: false };
}

/**
 * The interval around a value in which something works. It tries the given values outwards, and narrows the threshold between
 * the last that works and the first that fails by bisection, to a thousandth of the value. A failure between two values that
 * work goes unnoticed.
 * @returns null if it doesn't work at the value itself
 */
export function intervalAround(own: number, values: readonly number[], works: (value: number) => boolean): Interval | null {
  if (!works(own)) return null;
  const sorted = [...values].sort((a, b) => a - b);
  const below = sorted.filter((value) => value < own).reverse();
  const low = follow(own, below, works);
  const above = sorted.filter((value) => value > own);
  const high = follow(own, above, works);
  return { low: low.end, high: high.end, isLowBound: low.isBound, isHighBound: high.isBound };
}
