import { type Motion, pairAt, SLOTS, TAYLOR_DEGREE, taylorStep } from '../../motion/index.ts';
import { CONVERGENCE, PIECE_SHARE } from '../../tolerances.ts';
import { rimOf } from './rim-flow.ts';

const { DEGREE, ACCELERATION } = SLOTS;

/** Longest piece, s. */
const LONGEST = 4;

const seriesX = new Float64Array(TAYLOR_DEGREE + 1);
const seriesY = new Float64Array(TAYLOR_DEGREE + 1);
const end = new Float64Array(4);

/** Projects her onto the rim, with her velocity along it. */
function ontoRim(m: Motion): void {
  const { ux, uy } = m;
  const rim = rimOf(m);
  const r = Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]);
  const nx = ux[0] / r;
  const ny = uy[0] / r;
  ux[0] = rim.radius * nx;
  uy[0] = rim.radius * ny;
  const across = ux[1] * nx + uy[1] * ny;
  if (rim.freeX && rim.freeY) {
    ux[1] -= across * nx;
    uy[1] -= across * ny;
  } else if (rim.freeX) {
    ux[1] = (-ny * uy[1]) / nx;
  } else if (rim.freeY) {
    uy[1] = (-nx * ux[1]) / ny;
  }
}

/**
 * Expands her motion along the rim. If pieces have the degree of the series, the piece is the series itself; otherwise it is
 * the polynomial that meets the series at its end. Slides are rare, so every accuracy takes them from the series; with fixed
 * steps, only the path between two steps is less accurate.
 * @returns the length for which the piece holds, s
 */
export function expandSlide(m: Motion, longest: number): number {
  const { s, ux, uy, px, py, integrator, scene } = m;
  const rim = rimOf(m);
  const degree = s[DEGREE];
  ontoRim(m);
  const precise = degree === TAYLOR_DEGREE;
  const x = precise ? ux : seriesX;
  const y = precise ? uy : seriesY;
  for (let k = 0; k < 2; k++) {
    x[k] = ux[k];
    y[k] = uy[k];
  }
  rim.series(x, y);
  const share = (scene.accuracy.tolerance ?? 1e-9) / PIECE_SHARE;
  const wx = ux[0] - rim.qx;
  const wy = uy[0] - rim.qy;
  const d = Math.sqrt(wx * wx + wy * wy);
  const v2 = (ux[1] - rim.qvx) * (ux[1] - rim.qvx) + (uy[1] - rim.qvy) * (uy[1] - rim.qvy);
  const strength = strongest(m, d) + rim.kappa;
  const toCentre = (2 * d) / (Math.sqrt(v2) + Math.sqrt(v2 + 2 * strength * d));
  const h = taylorStep(x, y, share, Math.min(longest, LONGEST, CONVERGENCE * toCentre));
  for (let k = 2; k <= degree; k++) px[k] = py[k] = 0;
  if (!precise) {
    meet(ux, x, degree, h);
    meet(uy, y, degree, h);
  }
  s[ACCELERATION] = 1.5 * strongest(m, d + (Math.sqrt(v2) + strength * h) * h);
  m.work.forceEvaluations += integrator.evaluations;
  return h;
}

/**
 * Upper bound of the force outside at most `d` px from its centre, px/s². While she slides, the push of the rim is no larger.
 */
function strongest(m: Motion, d: number): number {
  const { alpha, beta } = rimOf(m);
  return Math.max(Math.abs(alpha), beta * d);
}

/**
 * The polynomial of degree 2 or 3 that begins like the series and meets its place at h, and its velocity if the degree allows.
 */
function meet(c: Float64Array, series: Float64Array, degree: number, h: number): void {
  let bend = 0;
  let gain = 0;
  for (let k = TAYLOR_DEGREE; k >= 2; k--) {
    bend = (bend + series[k]) * h;
    gain = (gain + k * series[k]) * h;
  }
  if (degree === 2) {
    c[2] = bend / h;
    return;
  }
  c[2] = (3 * bend - gain) / h;
  c[3] = (gain - 2 * bend) / (h * h);
}

/** Writes place and velocity after `t` of a piece along the rim to out[0..3]. */
export function arriveOnRim(m: Motion, t: number, out: Float64Array): void {
  const { ux, uy } = m;
  if (m.integrator.degree === TAYLOR_DEGREE) {
    pairAt(ux, uy, TAYLOR_DEGREE, t, out, 0);
    return;
  }
  for (let k = 0; k < 2; k++) {
    seriesX[k] = ux[k];
    seriesY[k] = uy[k];
  }
  rimOf(m).series(seriesX, seriesY);
  pairAt(seriesX, seriesY, TAYLOR_DEGREE, t, end, 0);
  out.set(end);
}
