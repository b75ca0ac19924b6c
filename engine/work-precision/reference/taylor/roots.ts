import { compare, type Dd, dd, divide, subtract, toNumber } from '../double-double.ts';
import { NotCovered } from '../stretch.ts';
import { DEGREE, degreeOf, derivative, Series, valueAt } from './series.ts';

/** A coefficient below this share of a guard's size is 0: 24 of 32 digits agree, and only an exact tie does that. */
export const NOTHING = 1e-24;

/** Intervals shorter than this share of the whole are not divided any more. */
const SHORTEST = 1 / 281_474_976_710_656; // 2^-48

/** More intervals than this are divided only where a series is almost 0 throughout. */
const MOST_INTERVALS = 10_000;

/** A piece of a series on which it rises or falls throughout. */
interface Piece {
  readonly from: Dd;
  readonly to: Dd;
}

/** A guard without what is exactly 0 at the start: it has the same sign as the guard right after the start. */
interface Opened {
  readonly guard: Series;
  /** How often the variable was divided out: 0 unless the guard begins at exactly 0. */
  readonly zeros: number;
}

/**
 * Divides by the variable as long as the guard begins at 0. What is left begins with the first term that is not 0.
 * @param end - how far the guard will be followed
 * @param size - natural size of the numbers that the guard is a difference of
 * @returns null if the guard is 0 throughout
 */
export function opened(guard: Series, end: number, size: number): Opened | null {
  let whole = size;
  for (let k = 0, power = 1; k <= DEGREE; k++, power *= end) whole += Math.abs(guard.hi[k]) * power;
  let zeros = 0;
  for (let power = 1; zeros <= DEGREE; zeros++, power *= end) {
    if (Math.abs(guard.hi[zeros]) * power > NOTHING * whole) break;
  }
  if (zeros > DEGREE) return null;
  if (zeros === 0) return { guard, zeros };
  const left = new Series();
  for (let k = zeros; k <= DEGREE; k++) left.set(k - zeros, guard.get(k));
  return { guard: left, zeros };
}

/**
 * The first moment from which a guard is below 0.
 * @param from - where to begin; at 0 the guard should be {@link opened}
 * @param end - where to stop
 * @param noise - how far from 0 rounding can take a value that is exactly 0, at a moment
 * @param miss - is told the smallest values not below 0 at which the guard turns round
 * @returns the moment, or null if there is none up to `end`
 */
export function firstBelow(
  guard: Series,
  from: Dd,
  end: Dd,
  noise: (at: Dd) => number,
  miss: (value: number) => void,
): Dd | null {
  const degree = degreeOf(guard);
  if (valueAt(guard, from, degree).hi < 0) return from;
  const slope = derivative(guard);
  for (const piece of monotonePieces(guard, slope, from, end, true)) {
    const b = valueAt(guard, piece.to, degree);
    if (b.hi < -noise(piece.to)) return crossing(guard, slope, piece, degree);
    if (compare(piece.to, end) < 0) miss(Math.max(0, toNumber(b)));
  }
  return null;
}

/** All moments at which a series changes its sign, in order. */
export function crossings(series: Series, from: Dd, end: Dd): Dd[] {
  const degree = degreeOf(series);
  if (degree === 0) return [];
  const slope = derivative(series);
  const found: Dd[] = [];
  for (const piece of monotonePieces(series, slope, from, end, false)) {
    const a = valueAt(series, piece.from, degree).hi;
    const b = valueAt(series, piece.to, degree).hi;
    if (a < 0 !== b < 0) found.push(crossing(series, slope, piece, degree));
  }
  return found;
}

/**
 * The pieces between `from` and `end` on which a series is monotone, in order; pieces that contain no sign change may be missing.
 * On an interval the third derivative bounds how far the series departs from its parabola at the middle.
 * @param positiveOnly - whether pieces that lie below 0 may not be left out
 */
function* monotonePieces(series: Series, slope: Series, from: Dd, end: Dd, positiveOnly: boolean): Generator<Piece> {
  const degree = degreeOf(series);
  const last = toNumber(end);
  const first = toNumber(from);
  let third = 0;
  let rounding = 0;
  for (let k = 0, power = 1, lower = 1; k <= degree; k++, power *= last) {
    const size = Math.abs(series.hi[k]);
    rounding += size * power;
    if (k < 3) continue;
    third += k * (k - 1) * (k - 2) * size * lower;
    lower *= last;
  }
  const start = series.hi[0];
  // too far from 0 to become it
  if (Math.abs(start) > (1 + 1e-10) * (rounding - Math.abs(start)) && (start > 0 || !positiveOnly)) return;
  rounding *= 1e-13;
  const second = derivative(slope);
  const point = (at: number): Dd => (at <= first ? from : at >= last ? end : dd(at));
  const stack: [number, number][] = [[first, last]];
  let intervals = 0;
  for (let interval = stack.pop(); interval !== undefined; interval = stack.pop()) {
    if (++intervals > MOST_INTERVALS) throw new NotCovered('a guard stays close to 0');
    const [a, b] = interval;
    const middle = (a + b) / 2;
    const half = (b - a) / 2;
    const g = roughValueAt(series, middle, degree);
    const g1 = roughValueAt(slope, middle, degree - 1);
    const g2 = roughValueAt(second, middle, degree - 2);
    const bend = (third * half * half * half) / 6 + rounding;
    const [low, high] = parabolaRange(g, g1, g2, half);
    if (low - bend > 0 || (!positiveOnly && high + bend < 0)) continue;
    const turn = Math.abs(g2) * half + (third * half * half) / 2;
    if (Math.abs(g1) > turn || b - a <= SHORTEST * (last - first)) {
      yield { from: point(a), to: point(b) };
      continue;
    }
    if (Math.abs(g2) > third * half) {
      const top = crossing(slope, second, { from: point(a), to: point(b) }, Math.max(0, degree - 1));
      yield { from: point(a), to: top };
      yield { from: top, to: point(b) };
      continue;
    }
    stack.push([middle, b], [a, middle]);
  }
}

/** The value in doubles. */
function roughValueAt({ hi }: Series, s: number, degree: number): number {
  let value = 0;
  for (let k = degree; k >= 0; k--) value = value * s + hi[k];
  return value;
}

/** The range of g + g1 s + g2 s^2 / 2 for |s| up to `half`. */
function parabolaRange(g: number, g1: number, g2: number, half: number): [number, number] {
  const left = g - g1 * half + (g2 * half * half) / 2;
  const right = g + g1 * half + (g2 * half * half) / 2;
  let low = Math.min(left, right);
  let high = Math.max(left, right);
  const vertex = g2 === 0 ? Number.POSITIVE_INFINITY : -g1 / g2;
  if (Math.abs(vertex) < half) {
    const value = g + (g1 * vertex) / 2;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return [low, high];
}

/** Where a series that is monotone on a piece is 0: Newton's method, kept in the piece. Without a sign change, the nearer end. */
function crossing(series: Series, slope: Series, { from, to }: Piece, degree: number): Dd {
  let low = from;
  let high = to;
  const a = valueAt(series, low, degree);
  const b = valueAt(series, high, degree);
  if (a.hi < 0 === b.hi < 0) return Math.abs(a.hi) < Math.abs(b.hi) ? low : high;
  const rising = a.hi < 0;
  let at = dd((toNumber(low) + toNumber(high)) / 2);
  for (let n = 0; n < 200; n++) {
    const value = valueAt(series, at, degree);
    if (value.hi === 0 && value.lo === 0) return at;
    if (value.hi < 0 === rising) low = at;
    else high = at;
    const gradient = valueAt(slope, at, Math.max(0, degree - 1));
    let next = gradient.hi === 0 ? low : subtract(at, divide(value, gradient));
    const moved = Math.abs(subtract(next, at).hi);
    if (!(compare(next, low) > 0 && compare(next, high) < 0)) {
      if (moved < 1e-30 * Math.abs(at.hi)) return at;
      next = dd((toNumber(low) + toNumber(high)) / 2);
      if (compare(next, low) <= 0 || compare(next, high) >= 0) return at;
    } else if (moved < 1e-29 * Math.abs(at.hi) || moved < 1e-34) {
      return next;
    }
    at = next;
  }
  return at;
}
