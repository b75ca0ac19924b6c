/** To this part of a level's value its threshold is found. */
const PRECISION = 1e-3;

/** Values that work, and how sure it is that there are no others beyond. */
export interface Interval {
  readonly low: number;
  readonly high: number;
  readonly isLowBound: boolean;
  readonly isHighBound: boolean;
}

/** The way from a value that works through others, up to the first that doesn't: then by halving. */
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
 * The interval around a value in which something works: it is looked at the given values, outwards, and between the last that
 * works and the first that doesn't by bisection, to a thousandth of the value. What fails between two values that work is not seen.
 * @returns null where it doesn't work at the value itself
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
