import { DRIFTS, IS_BASE, LINEAR, type Motion, SERIES, SLOTS, TURNS } from '../motion/index.ts';

const { HELD, FIELD, TARGET, BASE_X, BASE_Y, KIND, TURN, DEGREE } = SLOTS;
const { TURN_NOT, TURN_TO_BASE } = TURNS;

// Numbers with twice the digits of a double: a sum of two doubles, the second at most half a unit in the last place of the
// first (Dekker 1971). A function that computes one returns the first and leaves the second here.
let low = 0;

function sum(a: number, b: number): number {
  const s = a + b;
  const v = s - a;
  low = a - (s - v) + (b - v);
  return s;
}

// 2^27 + 1
const SPLIT = 134_217_729;

function product(a: number, b: number): number {
  const p = a * b;
  const ca = SPLIT * a;
  const ah = ca - (ca - a);
  const al = a - ah;
  const cb = SPLIT * b;
  const bh = cb - (cb - b);
  const bl = b - bh;
  low = ah * bh - p + ah * bl + al * bh + al * bl;
  return p;
}

function add(ah: number, al: number, bh: number, bl: number): number {
  const s = sum(ah, bh);
  const rest = low + (al + bl);
  const h = s + rest;
  low = rest - (h - s);
  return h;
}

function multiply(ah: number, al: number, bh: number, bl: number): number {
  const p = product(ah, bh);
  const rest = low + (ah * bl + al * bh);
  const h = p + rest;
  low = rest - (h - p);
  return h;
}

function root(ah: number, al: number): number {
  if (!(ah > 0)) {
    low = 0;
    return 0;
  }
  const q = Math.sqrt(ah);
  const square = product(q, q);
  const left = add(ah, al, -square, -low);
  const rest = left / (2 * q);
  const h = q + rest;
  low = rest - (h - q);
  return h;
}

/** a1 b1 + sign a2 b2, of numbers at `a`, `b`, `c` and `d` in `pairs`. */
function products(a: number, b: number, c: number, d: number, sign: number): number {
  const first = multiply(pairs[a], pairs[a + 1], pairs[b], pairs[b + 1]);
  const firstLow = low;
  const second = multiply(pairs[c], pairs[c + 1], pairs[d], pairs[d + 1]);
  return add(first, firstLow, sign * second, sign * low);
}

// first and second part of each: circle minus her, direction of the box
const DX = 0;
const DY = 2;
const BX = 4;
const BY = 6;
const pairs = new Float64Array(8);

function keep(at: number, h: number, l: number): void {
  pairs[at] = h;
  pairs[at + 1] = l;
}

/** What a polynomial adds to its first coefficient by `t`. */
function gain(c: Float64Array, degree: number, t: number): number {
  let v = 0;
  for (let k = degree; k >= 1; k--) v = (v + c[k]) * t;
  return v;
}

/** The circle's centre minus hers, along one axis. */
function relativeAlong(m: Motion, t: number, y: boolean): number {
  const { s } = m;
  const degree = s[DEGREE];
  const u = y ? m.uy : m.ux;
  const p = y ? m.py : m.px;
  const base = y ? s[BASE_Y] : s[BASE_X];
  const moved = gain(u, degree, t);
  let h = sum(-u[0], -moved);
  if (m.circleMotion === IS_BASE) return h;
  if (m.recoil) h = add(h, low, -p[0] - gain(p, degree, t), 0);
  if (m.circleMotion === SERIES) {
    const q = y ? m.chaserY[m.circleSeries] : m.chaserX[m.circleSeries];
    h = add(h, low, gain(q, m.integrator.degree, t), 0);
    h = add(h, low, q[0], 0);
    return add(h, low, -base, 0);
  }
  h = add(h, low, y ? m.circleFromY : m.circleFromX, 0);
  h = add(h, low, y ? -m.circleOffY : -m.circleOffX, 0);
  h = add(h, low, -base, 0);
  return m.circleMotion === DRIFTS ? add(h, low, (y ? m.circleVY : m.circleVX) * t, 0) : h;
}

/** The vector from her to the centre of the frame, along one axis. */
function toBaseAlong(m: Motion, t: number, y: boolean): number {
  const u = y ? m.uy : m.ux;
  return sum(-u[0], -gain(u, m.s[DEGREE], t));
}

/** The direction of the box, not of length 1, with all digits where the state has more than cos and sin. */
function look(m: Motion, t: number, cos: number, sin: number): void {
  const { s } = m;
  if (s[TURN] === TURN_TO_BASE) {
    keep(BX, toBaseAlong(m, t, false), low);
    keep(BY, toBaseAlong(m, t, true), low);
  } else if (s[TURN] !== TURN_NOT && !m.recoil) {
    const x = toBaseAlong(m, t, false);
    const xx = add(x, low, m.targetX[s[TARGET]], 0);
    keep(BX, add(xx, low, -s[BASE_X], 0), low);
    const y = toBaseAlong(m, t, true);
    const yy = add(y, low, m.targetY[s[TARGET]], 0);
    keep(BY, add(yy, low, -s[BASE_Y], 0), low);
  } else if (s[TURN] === TURN_NOT && s[KIND] === LINEAR && s[HELD] === 1 && s[FIELD] < 0) {
    // on a line the direction is constant: cos and sin are her place on it, rounded
    keep(BX, -m.ux[0], 0);
    keep(BY, -m.uy[0], 0);
  }
  const x = pairs[BX];
  const y = pairs[BY];
  const d = Math.sqrt(x * x + y * y);
  if (d > 1e-6 && Math.abs(x * sin - y * cos) <= 1e-15 * d && x * cos + y * sin > 0) return;
  keep(BX, cos, 0);
  keep(BY, sin, 0);
}

/**
 * The gap between her box and the placed circle after `t`, px, computed in twice the digits. Where the gap is tiny compared
 * with the radius or the distance, these digits matter. What remains is the rounding of her path since the piece began, about
 * 1e-16 of its length, so ties are exact at the start of a piece.
 * @param cos - direction of the box, rounded
 * @param sin - likewise
 */
export function fineGap(m: Motion, t: number, r: number, cos: number, sin: number): number {
  keep(BX, 0, 0);
  keep(BY, 0, 0);
  look(m, t, cos, sin);
  keep(DX, relativeAlong(m, t, false), low);
  keep(DY, relativeAlong(m, t, true), low);
  // all lengths are multiplied by |b|
  const squared = products(BX, BX, BY, BY, 1);
  const q = root(squared, low);
  const ql = low;
  let x = products(BX, DX, BY, DY, 1);
  let xl = low;
  let y = products(BX, DY, BY, DX, -1);
  let yl = low;
  const width = multiply(q, ql, m.box.halfWidth, 0);
  x = x < 0 ? add(-x, -xl, -width, -low) : add(x, xl, -width, -low);
  xl = low;
  const height = multiply(q, ql, m.box.halfHeight, 0);
  y = y < 0 ? add(-y, -yl, -height, -low) : add(y, yl, -height, -low);
  yl = low;
  if (x <= 0 && y <= 0) return -r;
  const reach = multiply(q, ql, r, 0);
  const reachLow = low;
  if (x <= 0) return add(y, yl, -reach, -reachLow) / q;
  if (y <= 0) return add(x, xl, -reach, -reachLow) / q;
  const xx = multiply(x, xl, x, xl);
  const xxl = low;
  const yy = multiply(y, yl, y, yl);
  const both = add(xx, xxl, yy, low);
  const bothLow = low;
  const rr = multiply(reach, reachLow, reach, reachLow);
  return add(both, bothLow, -rr, -low) / (q * (Math.sqrt(both) + reach));
}
