import { add, type Dd, multiply, sumOfProducts, ZERO } from '../double-double.ts';

/** The degree of all series. With 32 digits the best degree is about as high. */
export const DEGREE = 30;

const SPLITTER = 134_217_729; // 2^27 + 1

// begun with a fraction, so that V8 keeps it, and its copies, as doubles
const ZEROS: readonly number[] = new Array(DEGREE + 1).fill(0.5).map(() => 0.5);
(ZEROS as number[]).fill(0);

/** A power series of degree {@link DEGREE}, its coefficients with 32 digits. */
export class Series {
  // copies of an array of doubles: typed arrays cost much more to make
  readonly hi: number[] = ZEROS.slice();
  readonly lo: number[] = ZEROS.slice();

  /** @param k - of which power */
  get(k: number): Dd {
    return { hi: this.hi[k], lo: this.lo[k] };
  }

  /** @param k - of which power */
  set(k: number, value: Dd): void {
    this.hi[k] = value.hi;
    this.lo[k] = value.lo;
  }

  /** A constant, or a constant and a slope. */
  static line(at: Dd, slope: Dd = ZERO): Series {
    const line = new Series();
    line.set(0, at);
    line.set(1, slope);
    return line;
  }
}

/** The highest power whose coefficient is not 0. */
export function degreeOf({ hi }: Series): number {
  let k = DEGREE;
  while (k > 0 && hi[k] === 0) k--;
  return k;
}

/** Coefficient `k` of the product of two series. Its error is about 1e-32 of the largest product. */
export const productAt = (a: Series, b: Series, k: number): Dd => sumOfProducts(a, b, k + 1, k, -1);

/** The product of two series, cut off at {@link DEGREE}. */
export function product(a: Series, b: Series): Series {
  const made = new Series();
  const last = Math.min(DEGREE, degreeOf(a) + degreeOf(b));
  for (let k = 0; k <= last; k++) made.set(k, productAt(a, b, k));
  return made;
}

/** Applies a function of coefficients of equal power: a sum or a difference. */
export function eachOf(a: Series, b: Series, of: (a: Dd, b: Dd) => Dd): Series {
  const made = new Series();
  for (let k = 0; k <= DEGREE; k++) {
    if (a.hi[k] !== 0 || b.hi[k] !== 0) made.set(k, of(a.get(k), b.get(k)));
  }
  return made;
}

/** The derivative, by the series' own variable. */
export function derivative(a: Series): Series {
  const made = new Series();
  for (let k = 1; k <= DEGREE; k++) {
    const { hi, lo } = a.get(k);
    // exact enough: k has 5 bits, so only the last digits of `hi` are rounded, and `lo` takes them
    const p = k * hi;
    const sa = SPLITTER * hi;
    const high = sa - (sa - hi);
    const e = k * high - p + k * (hi - high) + k * lo;
    const sum = p + e;
    made.hi[k - 1] = sum;
    made.lo[k - 1] = e - (sum - p);
  }
  return made;
}

/** The value at `s`, by Horner's scheme. */
export function valueAt(a: Series, s: Dd, degree = degreeOf(a)): Dd {
  const { hi: ahs, lo: als } = a;
  const xh = s.hi;
  const xl = s.lo;
  const sx = SPLITTER * xh;
  const xhh = sx - (sx - xh);
  const xhl = xh - xhh;
  let h = ahs[degree];
  let l = als[degree];
  for (let k = degree - 1; k >= 0; k--) {
    const p = h * xh;
    const sh = SPLITTER * h;
    const hh = sh - (sh - h);
    const hl = h - hh;
    const e = hh * xhh - p + hh * xhl + hl * xhh + hl * xhl + (h * xl + l * xh);
    const ah = ahs[k];
    const sum = p + ah;
    const part = sum - p;
    const rest = p - (sum - part) + (ah - part) + (e + als[k]);
    h = sum + rest;
    l = rest - (h - sum);
  }
  return { hi: h, lo: l };
}

/** The same function as a series about another point. */
export function about(a: Series, point: Dd): Series {
  const made = new Series();
  const degree = degreeOf(a);
  for (let k = 0; k <= degree; k++) made.set(k, a.get(k));
  // Horner's scheme, again and again
  for (let from = 0; from < degree; from++) {
    for (let k = degree - 1; k >= from; k--) made.set(k, add(made.get(k), multiply(made.get(k + 1), point)));
  }
  return made;
}
