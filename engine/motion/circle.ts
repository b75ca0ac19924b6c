import type { Motion } from './motion.ts';
import { pairAt, shift } from './polynomial.ts';
import { ALERTNESS, RECORDS, SLOTS } from './state.ts';

const { TARGET, BASE, BASE_X, BASE_Y, DEGREE } = SLOTS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;

// how the circle of a contact moves
const STILL = 0;

export const DRIFTS = 1;

export const SERIES = 2;

export const IS_BASE = 3;

/**
 * Makes a circle that stands still the one that guards examine.
 * @param x - x of its centre, px
 * @param y - y of its centre, px
 * @param offX - x of the motion's origin in the coordinates of `x` and `y`, px
 * @param offY - y of that origin, px
 */
export function placeCircle(m: Motion, x: number, y: number, offX: number, offY: number): void {
  m.circleFromX = x;
  m.circleFromY = y;
  m.circleOffX = offX;
  m.circleOffY = offY;
  m.circleX = x - offX - m.s[BASE_X];
  m.circleY = y - offY - m.s[BASE_Y];
  m.circleMotion = STILL;
}

/** Makes a target the circle that guards examine, wherever recoil moves it. */
export function placeRock(m: Motion, i: number): void {
  const { s } = m;
  if (!m.recoil) {
    placeCircle(m, m.targetX[i], m.targetY[i], 0, 0);
    return;
  }
  const dragged = m.chaserX.length - 1;
  if (i === s[BASE]) {
    m.circleMotion = IS_BASE;
    return;
  }
  if (i === s[TARGET] && s[m.chasers + CHASER * dragged + 4] === AWAKE) {
    m.circleMotion = SERIES;
    m.circleSeries = dragged;
    return;
  }
  const o = m.rocks + ROCK * i;
  placeCircle(m, s[o], s[o + 1], 0, 0);
  m.circleMotion = DRIFTS;
  m.circleVX = s[o + 2];
  m.circleVY = s[o + 3];
}

/** Makes a chaser the circle that guards examine, on its chase if it is awake. */
export function placeChaser(m: Motion, i: number): void {
  const o = m.chasers + CHASER * i;
  placeCircle(m, m.s[o], m.s[o + 1], 0, 0);
  if (m.s[o + 4] !== AWAKE) return;
  m.circleMotion = SERIES;
  m.circleSeries = i;
}

/** Writes her state after `t` s to `m.her`, and to `m.toCircle` the vector from her to the centre of the placed circle. */
export function relativeAt(m: Motion, t: number): void {
  const { s, her, toCircle, budget } = m;
  if (++budget.looks > budget.most) budget.end();
  const degree = s[DEGREE];
  pairAt(m.ux, m.uy, degree, t, her, 0);
  if (m.circleMotion === IS_BASE) {
    toCircle[0] = -her[0];
    toCircle[1] = -her[1];
    toCircle[2] = -her[2];
    toCircle[3] = -her[3];
    return;
  }
  if (m.circleMotion === SERIES) {
    pairAt(m.chaserX[m.circleSeries], m.chaserY[m.circleSeries], m.integrator.degree, t, toCircle, 0);
    toCircle[0] -= s[BASE_X];
    toCircle[1] -= s[BASE_Y];
  } else if (m.circleMotion === DRIFTS) {
    toCircle[0] = m.circleX + m.circleVX * t;
    toCircle[1] = m.circleY + m.circleVY * t;
    toCircle[2] = m.circleVX;
    toCircle[3] = m.circleVY;
  } else {
    toCircle[0] = m.circleX;
    toCircle[1] = m.circleY;
    toCircle[2] = 0;
    toCircle[3] = 0;
  }
  toCircle[0] -= her[0];
  toCircle[1] -= her[1];
  toCircle[2] -= her[2];
  toCircle[3] -= her[3];
  if (!m.recoil) return;
  const { base } = m;
  pairAt(m.px, m.py, degree, t, base, 0);
  toCircle[0] -= base[0];
  toCircle[1] -= base[1];
  toCircle[2] -= base[2];
  toCircle[3] -= base[3];
}

/**
 * The circle's centre minus hers as polynomials with coefficients about `t`.
 * @param x - receives the coefficients; at least {@link LONGEST_SERIES} numbers
 * @param y - likewise
 * @returns their degree
 */
export function relativeSeries(m: Motion, t: number, x: Float64Array, y: Float64Array): number {
  const { s } = m;
  m.budget.look(8);
  const degree = s[DEGREE];
  const motion = m.circleMotion;
  const series = motion === SERIES ? m.integrator.degree : 0;
  const moves = m.recoil && motion !== IS_BASE;
  x.fill(0);
  y.fill(0);
  if (motion === SERIES) {
    for (let k = 0; k <= series; k++) {
      x[k] = m.chaserX[m.circleSeries][k];
      y[k] = m.chaserY[m.circleSeries][k];
    }
    x[0] -= s[BASE_X];
    y[0] -= s[BASE_Y];
  } else if (motion !== IS_BASE) {
    x[0] = m.circleX;
    y[0] = m.circleY;
    if (motion === DRIFTS) {
      x[1] = m.circleVX;
      y[1] = m.circleVY;
    }
  }
  for (let k = 0; k <= degree; k++) {
    x[k] -= m.ux[k] + (moves ? m.px[k] : 0);
    y[k] -= m.uy[k] + (moves ? m.py[k] : 0);
  }
  const highest = Math.max(degree, series);
  shift(x, highest, t);
  shift(y, highest, t);
  return highest;
}
