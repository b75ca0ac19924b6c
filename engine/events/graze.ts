import { addProduct, LONGEST_SERIES, type Motion, relativeSeries, SLOTS, shift, TURNS } from '../motion/index.ts';
import { FLOOR } from '../tolerances.ts';
import { safeStretch } from './roots.ts';

const { TURN, DEGREE } = SLOTS;
const { TURN_TO_BASE } = TURNS;

const dx = new Float64Array(LONGEST_SERIES);
const dy = new Float64Array(LONGEST_SERIES);
const bx = new Float64Array(LONGEST_SERIES);
const by = new Float64Array(LONGEST_SERIES);
const along = new Float64Array(LONGEST_SERIES);
const product = new Float64Array(2 * LONGEST_SERIES);

/**
 * Largest radius up to which a side is followed by its polynomial, px. Up to this radius the rounding of products with it stays
 * below 4e-11 px, which may then be overlooked in addition.
 */
const LARGEST_BESIDE = 1e4;

/** Rounding error of a side's polynomial, relative to radius plus half side. */
const SIDE_ROUNDING = 3.6e-15;

/**
 * A safe step of the march in `contact.ts` for a gap that stays near 0 for long. It uses the coefficients of the motion, which
 * say how the gap goes on, where a bound of the acceleration must assume the worst. Names are those of `contact.ts`.
 *
 * N.D(t) is a polynomial. For a box that does not turn, gap(t) >= g + N.(D(t) - D(0)). A box that turns is followed by its four
 * corners, with their rotation bounded as there. If a side is nearest and the box is turned towards the centre of the frame,
 * along c, there is a third bound. The side's own direction separates box and circle while c.D / |c| - 10 px - r >= 0 (c x D
 * and 16 px for the other sides). Since |c| <= (c.c + b²) / (2 b) for any b > 0, this follows from
 * c.D - (10 px + r) (c.c + b²) / (2 b) >= 0. That is a polynomial, and with b = |c(0)| it is exact up to the square of the
 * change of |c|. If she circles about what she nearly touches, all of it is constant.
 * @param above - gap from which to follow, px
 * @param longest - longest step, s
 * @returns s, at most `longest`
 */
export function grazeStep(
  m: Motion,
  t: number,
  r: number,
  above: number,
  ax: number,
  ay: number,
  qx: number,
  qy: number,
  cos: number,
  sin: number,
  omega: number,
  swing: number,
  cap: number,
  longest: number,
): number {
  const degree = relativeSeries(m, t, dx, dy);
  const nx = ax * cos - ay * sin;
  const ny = ax * sin + ay * cos;
  for (let k = 0; k <= degree; k++) along[k] = nx * dx[k] + ny * dy[k];
  const slope = along[1];
  if (swing === 0) return safeStretch(along, degree, above, slope, 0, Math.min(cap, longest));

  let step = Math.min(cap, longest);
  const { halfWidth, halfHeight, halfDiagonal } = m.box;
  for (let x = -halfWidth; x <= halfWidth; x += 2 * halfWidth) {
    for (let y = -halfHeight; y <= halfHeight; y += 2 * halfHeight) {
      const value = above + ax * (qx - x) + ay * (qy - y);
      step = Math.min(step, safeStretch(along, degree, value, slope + omega * (ax * y - ay * x), halfDiagonal * swing, step));
    }
  }
  const beside = ax === 0 || ay === 0;
  return beside && r <= LARGEST_BESIDE && m.s[TURN] === TURN_TO_BASE
    ? Math.max(step, besideStep(m, t, r, above, ax, ay, degree, longest))
    : step;
}

/** The step along a side; `dx` and `dy` hold D. */
function besideStep(
  m: Motion,
  t: number,
  r: number,
  above: number,
  ax: number,
  ay: number,
  degree: number,
  longest: number,
): number {
  const own = m.s[DEGREE];
  for (let k = 0; k <= own; k++) {
    bx[k] = -m.ux[k];
    by[k] = -m.uy[k];
  }
  shift(bx, own, t);
  shift(by, own, t);
  const size = Math.sqrt(bx[0] * bx[0] + by[0] * by[0]);
  const half = ay === 0 ? m.box.halfWidth : m.box.halfHeight;
  const squares = -(half + r) / (2 * size);
  product.fill(0);
  if (ay === 0) {
    addProduct(bx, own, dx, degree, ax, product);
    addProduct(by, own, dy, degree, ax, product);
  } else {
    addProduct(bx, own, dy, degree, ay, product);
    addProduct(by, own, dx, degree, -ay, product);
  }
  addProduct(bx, own, bx, own, squares, product);
  addProduct(by, own, by, own, squares, product);
  const rounding = SIDE_ROUNDING * (half + r);
  // as in `above`, up to FLOOR may be overlooked; a large radius has a larger rounding error
  const value = (above + Math.max(0, rounding - FLOOR)) * size;
  return safeStretch(product, own + degree, value, product[1], 0, longest);
}
