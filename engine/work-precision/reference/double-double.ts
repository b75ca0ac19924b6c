/**
 * A number with about 32 digits: the sum of two doubles, the second at most half a unit in the last place of the first. The
 * arithmetic is Dekker's and Knuth's.
 */
export interface Dd {
  readonly hi: number;
  readonly lo: number;
}

/** Splits a double into two halves of 26 bits. */
const SPLITTER = 134_217_729; // 2^27 + 1

export const ZERO: Dd = { hi: 0, lo: 0 };
export const ONE: Dd = { hi: 1, lo: 0 };

/** A double, exactly. */
export const dd = (value: number): Dd => ({ hi: value, lo: 0 });

/** The sum of two doubles of any size, exactly. */
export function twoSum(a: number, b: number): Dd {
  const hi = a + b;
  const part = hi - a;
  return { hi, lo: a - (hi - part) + (b - part) };
}

/** The product of two doubles, exactly. */
function twoProduct(a: number, b: number): Dd {
  const hi = a * b;
  const sa = SPLITTER * a;
  const ah = sa - (sa - a);
  const al = a - ah;
  const sb = SPLITTER * b;
  const bh = sb - (sb - b);
  const bl = b - bh;
  return { hi, lo: ah * bh - hi + ah * bl + al * bh + al * bl };
}

/** The sum of two doubles of which the first is not the smaller one. */
function quickSum(a: number, b: number): Dd {
  const hi = a + b;
  return { hi, lo: b - (hi - a) };
}

export function add(a: Dd, b: Dd): Dd {
  const s = twoSum(a.hi, b.hi);
  const t = twoSum(a.lo, b.lo);
  const u = quickSum(s.hi, s.lo + t.hi);
  return quickSum(u.hi, u.lo + t.lo);
}

export const negate = (a: Dd): Dd => ({ hi: -a.hi, lo: -a.lo });

export const subtract = (a: Dd, b: Dd): Dd => add(a, negate(b));

export function multiply(a: Dd, b: Dd): Dd {
  const p = twoProduct(a.hi, b.hi);
  return quickSum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/** The product with a double. */
export const times = (a: Dd, factor: number): Dd => multiply(a, dd(factor));

export function divide(a: Dd, b: Dd): Dd {
  const q1 = a.hi / b.hi;
  const r1 = subtract(a, times(b, q1));
  const q2 = r1.hi / b.hi;
  const r2 = subtract(r1, times(b, q2));
  const q = quickSum(q1, q2);
  return add(q, dd(r2.hi / b.hi));
}

/** The square root; 0 for what is not above 0. */
export function squareRoot(a: Dd): Dd {
  if (!(a.hi > 0)) return ZERO;
  const root = dd(Math.sqrt(a.hi));
  // one step of Newton doubles the digits
  return add(root, divide(subtract(a, multiply(root, root)), times(root, 2)));
}

/** Below 0 if `a` is the smaller one, 0 if both are the same, above 0 otherwise. */
export const compare = (a: Dd, b: Dd): number => (a.hi === b.hi ? a.lo - b.lo : a.hi - b.hi);

export const toNumber = (a: Dd): number => a.hi + a.lo;

/** A place or another vector in the plane. */
export interface Vector {
  readonly x: Dd;
  readonly y: Dd;
}

export const NOWHERE: Vector = { x: ZERO, y: ZERO };

export const vector = (x: number, y: number): Vector => ({ x: dd(x), y: dd(y) });
export const plus = (a: Vector, b: Vector): Vector => ({ x: add(a.x, b.x), y: add(a.y, b.y) });
export const minus = (a: Vector, b: Vector): Vector => ({ x: subtract(a.x, b.x), y: subtract(a.y, b.y) });
export const scaled = (a: Vector, factor: Dd): Vector => ({ x: multiply(a.x, factor), y: multiply(a.y, factor) });
export const dot = (a: Vector, b: Vector): Dd => add(multiply(a.x, b.x), multiply(a.y, b.y));
export const cross = (a: Vector, b: Vector): Dd => subtract(multiply(a.x, b.y), multiply(a.y, b.x));
export const length = (a: Vector): Dd => squareRoot(dot(a, a));

/** The length of a vector in doubles. */
export const roughLength = (x: number, y: number): number => Math.sqrt(x * x + y * y);

/** Whether a vector is shorter than a length. */
export const isShort = (a: Vector, most: number): boolean => roughLength(a.x.hi, a.y.hi) < most;

/** The direction of a vector that is not 0. */
export const direction = (a: Vector): Vector => scaled(a, divide(ONE, length(a)));

/** Numbers with 32 digits in two arrays. */
export interface Numbers {
  readonly hi: number[];
  readonly lo: number[];
}

/**
 * The sum of the first products of two lists, `b` read from one place on, forwards or backwards. Its error is about 1e-32 of the
 * largest product.
 */
export function sumOfProducts(
  { hi: ahs, lo: als }: Numbers,
  { hi: bhs, lo: bls }: Numbers,
  count: number,
  from: number,
  step: 1 | -1,
): Dd {
  let sum = 0;
  let rest = 0;
  for (let i = 0; i < count; i++) {
    const j = from + step * i;
    const ah = ahs[i];
    const bh = bhs[j];
    if (ah === 0 || bh === 0) continue;
    // the product of the leading doubles, exactly: p + e
    const p = ah * bh;
    const sa = SPLITTER * ah;
    const ahh = sa - (sa - ah);
    const ahl = ah - ahh;
    const sb = SPLITTER * bh;
    const bhh = sb - (sb - bh);
    const bhl = bh - bhh;
    const e = ahh * bhh - p + ahh * bhl + ahl * bhh + ahl * bhl;
    const next = sum + p;
    const part = next - sum;
    rest += sum - (next - part) + (p - part) + (e + (ah * bls[j] + als[i] * bh));
    sum = next;
  }
  const hi = sum + rest;
  return { hi, lo: rest - (hi - sum) };
}
