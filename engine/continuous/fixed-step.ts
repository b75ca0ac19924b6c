import type { Flow } from './flow.ts';
import { valueAt } from './polynomial.ts';

// scratch: accelerations at the stages, and what a step adds
const a = new Float64Array(8);
const gain = new Float64Array(4);
const unused = new Float64Array(4);

/** Semi-implicit Euler: v1 = v0 + a0 h, x = x0 + v1 t. */
export function eulerStep(flow: Flow, x: Float64Array, y: Float64Array, h: number): void {
  flow.accelerate(x[0], y[0], a, 0);
  x[2] = 0;
  y[2] = 0;
  x[1] += a[0] * h;
  y[1] += a[1] * h;
}

/** Velocity Verlet: x = x0 + v0 t + a0 t^2 / 2. */
export function verletStep(flow: Flow, x: Float64Array, y: Float64Array): void {
  flow.accelerate(x[0], y[0], a, 0);
  x[2] = a[0] / 2;
  y[2] = a[1] / 2;
}

/** Place and velocity after `t` of a Verlet step: the velocity by the mean of the accelerations at both ends. */
export function verletEnd(flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array): void {
  flow.accelerate(x[0], y[0], a, 0);
  out[0] = ((a[0] / 2) * t + x[1]) * t + x[0];
  out[1] = ((a[1] / 2) * t + y[1]) * t + y[0];
  flow.accelerate(out[0], out[1], a, 2);
  out[2] = x[1] + (a[0] / 2 + a[2] / 2) * t;
  out[3] = y[1] + (a[1] / 2 + a[3] / 2) * t;
}

/**
 * Classical 4th-order Runge-Kutta for x'' = f(x): place and velocity after `h`, into out[0..3].
 * Leaves in `gain` what the step adds: the place beyond h v0, and the velocity.
 */
export function rungeKuttaEnd(flow: Flow, x: Float64Array, y: Float64Array, h: number, out: Float64Array): void {
  const x0 = x[0];
  const y0 = y[0];
  const vx = x[1];
  const vy = y[1];
  const half = h / 2;
  const quarter = half * half;
  flow.accelerate(x0, y0, a, 0);
  const ax = a[0];
  const ay = a[1];
  const middleX = x0 + half * vx;
  const middleY = y0 + half * vy;
  flow.accelerate(middleX, middleY, a, 0);
  const bx = a[0];
  const by = a[1];
  flow.accelerate(middleX + quarter * ax, middleY + quarter * ay, a, 0);
  const cx = a[0];
  const cy = a[1];
  flow.accelerate(x0 + h * vx + 2 * quarter * bx, y0 + h * vy + 2 * quarter * by, a, 0);
  const sixth = h / 6;
  const gx = sixth * h * (ax + bx + cx);
  const gy = sixth * h * (ay + by + cy);
  const gvx = sixth * (ax + 2 * (bx + cx) + a[0]);
  const gvy = sixth * (ay + 2 * (by + cy) + a[1]);
  gain[0] = gx;
  gain[1] = gy;
  gain[2] = gvx;
  gain[3] = gvy;
  out[0] = x0 + (h * vx + gx);
  out[1] = y0 + (h * vy + gy);
  out[2] = vx + gvx;
  out[3] = vy + gvy;
}

/** The same step as the cubic that meets place and velocity at both ends. */
export function rungeKuttaStep(flow: Flow, x: Float64Array, y: Float64Array, h: number): void {
  rungeKuttaEnd(flow, x, y, h, unused);
  cubic(x, y, h);
}

/** The cubic from what a step adds to the straight line: no digits are lost. */
function cubic(x: Float64Array, y: Float64Array, h: number): void {
  const bendX = gain[0] / h;
  const bendY = gain[1] / h;
  x[2] = (3 * bendX - gain[2]) / h;
  y[2] = (3 * bendY - gain[3]) / h;
  x[3] = (gain[2] - 2 * bendX) / (h * h);
  y[3] = (gain[3] - 2 * bendY) / (h * h);
}

/** How a body that another one drags along is advanced: q'' = kappa d / |d|, with d read from a known piece. */
export type DragStep = (
  qx: Float64Array,
  qy: Float64Array,
  ax: Float64Array,
  ay: Float64Array,
  degree: number,
  kappa: number,
  chase: boolean,
  h: number,
) => void;

function drag(x: number, y: number, kappa: number, at: number): void {
  const d = Math.sqrt(x * x + y * y);
  a[at] = d > 0 ? (kappa * x) / d : 0;
  a[at + 1] = d > 0 ? (kappa * y) / d : 0;
}

/**
 * Runge-Kutta step of a body q with q'' = kappa d / |d|, where d = a(t) - q when it chases the place a,
 * and d = a(t) when a is already relative to it.
 */
export const dragRungeKutta: DragStep = (qx, qy, ax, ay, degree, kappa, chase, h) => {
  const x0 = qx[0];
  const y0 = qy[0];
  const vx = qx[1];
  const vy = qy[1];
  const own = chase ? 1 : 0;
  const half = h / 2;
  const quarter = (h * h) / 4;
  const midX = valueAt(ax, degree, half);
  const midY = valueAt(ay, degree, half);
  drag(ax[0] - own * x0, ay[0] - own * y0, kappa, 0);
  drag(midX - own * (x0 + half * vx), midY - own * (y0 + half * vy), kappa, 2);
  drag(midX - own * (x0 + half * vx + quarter * a[0]), midY - own * (y0 + half * vy + quarter * a[1]), kappa, 4);
  drag(
    valueAt(ax, degree, h) - own * (x0 + h * vx + 2 * quarter * a[2]),
    valueAt(ay, degree, h) - own * (y0 + h * vy + 2 * quarter * a[3]),
    kappa,
    6,
  );
  const sixth = h / 6;
  gain[0] = sixth * h * (a[0] + a[2] + a[4]);
  gain[1] = sixth * h * (a[1] + a[3] + a[5]);
  gain[2] = sixth * (a[0] + 2 * a[2] + 2 * a[4] + a[6]);
  gain[3] = sixth * (a[1] + 2 * a[3] + 2 * a[5] + a[7]);
  cubic(qx, qy, h);
};

/** The same with the acceleration at the start of the step, as a quadratic: for Euler and Verlet. */
export const dragQuadratic: DragStep = (qx, qy, ax, ay, _degree, kappa, chase) => {
  const own = chase ? 1 : 0;
  drag(ax[0] - own * qx[0], ay[0] - own * qy[0], kappa, 0);
  qx[2] = a[0] / 2;
  qy[2] = a[1] / 2;
};
