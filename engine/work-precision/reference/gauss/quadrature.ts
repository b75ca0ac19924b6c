import { add, type Dd, dd, divide, multiply, type Numbers, ONE, subtract, sumOfProducts, times, ZERO } from '../double-double.ts';

/** Stages of the collocation: its order is twice as high. */
export const STAGES = 16;

/** As many numbers as there are stages. */
export type Column = Numbers;

// begun with a fraction, so that V8 keeps it, and its copies, as doubles
const FRACTIONS: readonly number[] = Array.from({ length: STAGES }, () => 0.5);

/** A column to be filled; copies of an array of doubles are cheaper to make than typed arrays. */
export const column = (): Column => ({ hi: FRACTIONS.slice(), lo: FRACTIONS.slice() });

export function put({ hi, lo }: Column, i: number, value: Dd): void {
  hi[i] = value.hi;
  lo[i] = value.lo;
}

/** The sum of the products of two columns. */
export const dotOf = (a: Column, b: Column): Dd => sumOfProducts(a, b, STAGES, 0, 1);

/** 1 / k. */
const INVERSES: readonly Dd[] = Array.from({ length: 2 * STAGES + 2 }, (_, k) => (k === 0 ? ZERO : divide(ONE, dd(k))));

/** Legendre polynomials P[0] to P[STAGES + 1] at a place in -1 to 1. */
function legendre(x: Dd): Dd[] {
  const p: Dd[] = [ONE, x];
  for (let n = 1; n <= STAGES; n++) {
    const next = subtract(times(multiply(x, p[n]), 2 * n + 1), times(p[n - 1], n));
    p.push(multiply(next, INVERSES[n + 1]));
  }
  return p;
}

/** The integrals of the first STAGES Legendre polynomials from -1 to a place, once and twice. */
export function integralsAt(x: Dd): { readonly once: Column; readonly twice: Column } {
  const p = legendre(x);
  const once = column();
  const twice = column();
  const first = add(x, ONE);
  const i: Dd[] = [first];
  for (let k = 1; k <= STAGES; k++) i.push(multiply(subtract(p[k + 1], p[k - 1]), INVERSES[2 * k + 1]));
  for (let k = 0; k < STAGES; k++) {
    put(once, k, i[k]);
    put(twice, k, k === 0 ? times(multiply(first, first), 0.5) : multiply(subtract(i[k + 1], i[k - 1]), INVERSES[2 * k + 1]));
  }
  return { once, twice };
}

/** What collocation at the nodes of Gauss and Legendre needs; a step is -1 to 1. */
export interface Rule {
  /** In a step, 0 to 1. */
  readonly nodes: readonly Dd[];
  /** Row k of values at the nodes gives the coefficient of P[k] of their interpolating polynomial. */
  readonly toLegendre: readonly Column[];
  /** Row j of values at the nodes gives the polynomial's integral from -1 to node j, once and twice. */
  readonly once: readonly Column[];
  readonly twice: readonly Column[];
}

let made: Rule | null = null;

/** The rule, which is made once. */
export function rule(): Rule {
  made ??= makeRule();
  return made;
}

function makeRule(): Rule {
  const places = rootsOfLegendre();
  const values = places.map(legendre);
  const weights = places.map((x, j) => {
    const slope = divide(times(subtract(values[j][STAGES - 1], multiply(x, values[j][STAGES])), STAGES), oneMinusSquare(x));
    return divide(dd(2), multiply(oneMinusSquare(x), multiply(slope, slope)));
  });
  const toLegendre = Array.from({ length: STAGES }, (_, k) => {
    const row = column();
    for (const [j, weight] of weights.entries()) put(row, j, times(multiply(weight, values[j][k]), k + 0.5));
    return row;
  });
  /** From Legendre coefficients to values at the nodes of the step themselves. */
  const through = (of: 'once' | 'twice') =>
    places.map((x) => {
      const integrals = integralsAt(x)[of];
      const row = column();
      for (let j = 0; j < STAGES; j++) {
        let sum = ZERO;
        for (let k = 0; k < STAGES; k++) {
          const part = multiply(at(integrals, k), at(toLegendre[k], j));
          sum = add(sum, part);
        }
        put(row, j, sum);
      }
      return row;
    });
  return {
    nodes: places.map((x) => times(add(x, ONE), 0.5)),
    toLegendre,
    once: through('once'),
    twice: through('twice'),
  };
}

const at = ({ hi, lo }: Column, i: number): Dd => ({ hi: hi[i], lo: lo[i] });

const oneMinusSquare = (x: Dd): Dd => subtract(ONE, multiply(x, x));

/** The roots of P[STAGES], ascending: from changes of sign, by bisection and then Newton's method. */
function rootsOfLegendre(): Dd[] {
  const value = (x: number): number => legendre(dd(x))[STAGES].hi;
  const roots: Dd[] = [];
  const cells = 40 * STAGES * STAGES;
  // halves of cells, so that none ends at the root 0 of odd degrees
  for (let i = 0; i <= cells; i++) {
    let low = -1 + (2 * i - 1) / cells;
    let high = -1 + (2 * i + 1) / cells;
    const below = value(low) < 0;
    if (below === value(high) < 0) continue;
    for (let n = 0; n < 60; n++) {
      const middle = (low + high) / 2;
      if (value(middle) < 0 === below) low = middle;
      else high = middle;
    }
    let root = dd(low);
    for (let n = 0; n < 4; n++) {
      const p = legendre(root);
      const slope = divide(times(subtract(p[STAGES - 1], multiply(root, p[STAGES])), STAGES), oneMinusSquare(root));
      root = subtract(root, divide(p[STAGES], slope));
    }
    roots.push(root);
  }
  return roots;
}
