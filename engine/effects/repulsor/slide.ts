import { type Motion, pairAt, SLOTS, TAYLOR_DEGREE, taylorStep } from '../../motion/index.ts';
import { CONVERGENCE, PIECE_SHARE } from '../../tolerances.ts';

const { DEGREE, ACCELERATION } = SLOTS;

/** Longest piece, s. */
const LONGEST = 4;

const seriesX = new Float64Array(TAYLOR_DEGREE + 1);
const seriesY = new Float64Array(TAYLOR_DEGREE + 1);
const end = new Float64Array(4);

const N = TAYLOR_DEGREE;
// working memory: power series of the place u, of w = u - q, of what is derived from them, and of q
const qx = new Float64Array(N + 1);
const qy = new Float64Array(N + 1);
const wx = new Float64Array(N + 1);
const wy = new Float64Array(N + 1);
const squares = new Float64Array(N + 1);
const inverse = new Float64Array(N + 1);
const outX = new Float64Array(N + 1);
const outY = new Float64Array(N + 1);
const share = new Float64Array(N + 1);
const denominator = new Float64Array(N + 1);
const pressure = new Float64Array(N - 1);

/**
 * Sliding along the rim of a field, in a frame about the field's centre. On either side of the rim a force drives her towards
 * it: inside, the push f_in = push u / |u|; outside, f_out = alpha w / |w| + beta w with w = u - q. The motion is Filippov's
 * sliding mode: the mean u'' = s f_out + (1 - s) f_in, with the share s that keeps her on the circle, u''.u = -|u'|².
 */
export class RimFlow {
  /** Radius of the field, px. */
  radius = 1;
  /** The push outwards inside the field, px/s². */
  push = 0;
  /** Coefficients of the force outside, px/s² and 1/s². */
  alpha = 0;
  beta = 0;
  /** The centre of the force outside and its velocity at the start of the piece, px and px/s. */
  qx = 0;
  qy = 0;
  qvx = 0;
  qvy = 0;
  /** How that centre accelerates towards her, px/s². */
  kappa = 0;
  /** False while the speed limit holds this axis. */
  freeX = true;
  freeY = true;
  /** The force outside that `weigh` found, px/s². */
  forceX = 0;
  forceY = 0;
  /**
   * How strongly that force presses her onto the rim against the centrifugal force, and how strongly push and centrifugal force
   * press from inside, px/s².
   */
  pressesIn = 0;
  pressesOut = 0;
  /** After `series`, while both axes are free: coefficients of pressesIn over time. All flows share this memory. */
  readonly pressure: Float64Array = pressure;

  /** Finds what acts at place u and velocity v if the centre of the force outside is at u - w. */
  weigh(x: number, y: number, vx: number, vy: number, wx: number, wy: number): void {
    const r = Math.sqrt(x * x + y * y);
    const nx = x / r;
    const ny = y / r;
    const d = Math.sqrt(wx * wx + wy * wy);
    const f = (d > 0 ? this.alpha / d : 0) + this.beta;
    this.forceX = f * wx;
    this.forceY = f * wy;
    const turning = (vx * vx + vy * vy) / r;
    const outside = (this.freeX ? this.forceX * nx : 0) + (this.freeY ? this.forceY * ny : 0);
    const within = (this.freeX ? nx * nx : 0) + (this.freeY ? ny * ny : 0);
    this.pressesIn = -outside - turning;
    this.pressesOut = this.push * within + turning;
  }

  /**
   * Writes the mean acceleration, after `weigh` at the same place, to out[at..at + 1]. For an axis at the speed limit it is
   * what the limit holds back.
   */
  accelerate(x: number, y: number, out: Float64Array, at: number): void {
    const r = Math.sqrt(x * x + y * y);
    const s = this.pressesOut / (this.pressesOut + this.pressesIn);
    out[at] = s * this.forceX + ((1 - s) * this.push * x) / r;
    out[at + 1] = s * this.forceY + ((1 - s) * this.push * y) / r;
  }

  /**
   * Power series of her place along the rim, of degree TAYLOR_DEGREE. On entry x[0..1], y[0..1] hold place and velocity. With S
   * = |v|² / radius and P = f_out.u / radius the share is s = (push + S) / (push - P): Cauchy products and one quotient.
   */
  series(x: Float64Array, y: Float64Array): void {
    qx[0] = this.qx;
    qy[0] = this.qy;
    qx[1] = this.qvx;
    qy[1] = this.qvy;
    if (!this.freeX || !this.freeY) {
      if (!this.freeX && !this.freeY) for (let n = 2; n <= N; n++) x[n] = y[n] = 0;
      else if (this.freeY) alongLimit(x, y);
      else alongLimit(y, x);
      return;
    }
    const { radius, alpha, beta, kappa } = this;
    for (let n = 0; n <= N - 2; n++) {
      wx[n] = x[n] - qx[n];
      wy[n] = y[n] - qy[n];
      let sum = 0;
      for (let k = 0; k <= n; k++) sum += wx[k] * wx[n - k] + wy[k] * wy[n - k];
      squares[n] = sum;
      if (n === 0) {
        inverse[0] = 1 / Math.sqrt(sum);
      } else {
        sum = 0;
        for (let k = 1; k <= n; k++) sum += (0.5 * k - n) * squares[k] * inverse[n - k];
        inverse[n] = sum / (n * squares[0]);
      }
      let towardsX = 0;
      let towardsY = 0;
      for (let k = 0; k <= n; k++) {
        towardsX += inverse[n - k] * wx[k];
        towardsY += inverse[n - k] * wy[k];
      }
      outX[n] = alpha * towardsX + beta * wx[n];
      outY[n] = alpha * towardsY + beta * wy[n];
      let turning = 0;
      let pressing = 0;
      for (let k = 0; k <= n; k++) {
        const c = (k + 1) * (n - k + 1);
        turning += c * (x[k + 1] * x[n - k + 1] + y[k + 1] * y[n - k + 1]);
        pressing += outX[k] * x[n - k] + outY[k] * y[n - k];
      }
      const one = n === 0 ? this.push : 0;
      denominator[n] = one - pressing / radius;
      this.pressure[n] = -(pressing + turning) / radius;
      let s = one + turning / radius;
      for (let k = 1; k <= n; k++) s -= denominator[k] * share[n - k];
      share[n] = s / denominator[0];
      let ax = 0;
      let ay = 0;
      for (let k = 0; k <= n; k++) {
        const push = (this.push / radius) * ((k === 0 ? 1 : 0) - share[k]);
        ax += share[k] * outX[n - k] + push * x[n - k];
        ay += share[k] * outY[n - k] + push * y[n - k];
      }
      const f = 1 / ((n + 1) * (n + 2));
      x[n + 2] = ax * f;
      y[n + 2] = ay * f;
      qx[n + 2] = kappa * towardsX * f;
      qy[n + 2] = kappa * towardsY * f;
    }
  }
}

/** On the rim with the speed limit holding one axis: a is linear in time, and b² = radius² - a². */
function alongLimit(a: Float64Array, b: Float64Array): void {
  for (let n = 2; n <= N; n++) a[n] = 0;
  b[1] = (-a[0] * a[1]) / b[0];
  for (let n = 2; n <= N; n++) {
    let sum = n === 2 ? -a[1] * a[1] : 0;
    for (let k = 1; k < n; k++) sum -= b[k] * b[n - k];
    b[n] = sum / (2 * b[0]);
  }
}

/** The forces that act while she slides along a rim, as `attach` has made them for this motion. */
export const rimOf = (m: Motion): RimFlow => m.rim as RimFlow;

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
  // from rest, where forces cancel up to rounding, she hardly moves: a bound by them would let each march to what she touches crawl
  const atRest = ux[1] === 0 && uy[1] === 0;
  s[ACCELERATION] = atRest ? steepest(ux, uy, degree, h) : 1.5 * strongest(m, d + (Math.sqrt(v2) + strength * h) * h);
  m.work.forceEvaluations += integrator.evaluations;
  return h;
}

/** Upper bound of the acceleration of a series up to `h` s, px/s². */
function steepest(x: Float64Array, y: Float64Array, degree: number, h: number): number {
  let most = 0;
  for (let k = degree; k > 1; k--) most = most * h + k * (k - 1) * (Math.abs(x[k]) + Math.abs(y[k]));
  return most;
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
