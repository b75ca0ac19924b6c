import type { Flow } from './flow.ts';
import { valueAt } from './polynomial.ts';

const a = new Float64Array(8);

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

/**
 * Classical 4th-order Runge-Kutta for x'' = f(x), as the cubic that meets place and velocity at both ends.
 * Writes place and velocity at the end to `end`: x, y, vx, vy.
 */
export function rungeKuttaStep(flow: Flow, x: Float64Array, y: Float64Array, h: number, end: Float64Array): void {
  const x0 = x[0];
  const y0 = y[0];
  const vx = x[1];
  const vy = y[1];
  const half = h / 2;
  const quarter = (h * h) / 4;
  flow.accelerate(x0, y0, a, 0);
  flow.accelerate(x0 + half * vx, y0 + half * vy, a, 2);
  flow.accelerate(x0 + half * vx + quarter * a[0], y0 + half * vy + quarter * a[1], a, 4);
  flow.accelerate(x0 + h * vx + 2 * quarter * a[2], y0 + h * vy + 2 * quarter * a[3], a, 6);
  const sixth = (h * h) / 6;
  const stepX = h * vx + sixth * (a[0] + a[2] + a[4]);
  const stepY = h * vy + sixth * (a[1] + a[3] + a[5]);
  const gainX = (h / 6) * (a[0] + 2 * a[2] + 2 * a[4] + a[6]);
  const gainY = (h / 6) * (a[1] + 2 * a[3] + 2 * a[5] + a[7]);
  end[0] = x0 + stepX;
  end[1] = y0 + stepY;
  end[2] = vx + gainX;
  end[3] = vy + gainY;
  // what the cubic adds to the straight line, from the increments: no digits are lost
  const bendX = (stepX - h * vx) / h;
  const bendY = (stepY - h * vy) / h;
  x[2] = (3 * bendX - gainX) / h;
  y[2] = (3 * bendY - gainY) / h;
  x[3] = (gainX - 2 * bendX) / (h * h);
  y[3] = (gainY - 2 * bendY) / (h * h);
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
  const bendX = (h / 6) * (a[0] + a[2] + a[4]);
  const bendY = (h / 6) * (a[1] + a[3] + a[5]);
  const gainX = (h / 6) * (a[0] + 2 * a[2] + 2 * a[4] + a[6]);
  const gainY = (h / 6) * (a[1] + 2 * a[3] + 2 * a[5] + a[7]);
  qx[2] = (3 * bendX - gainX) / h;
  qy[2] = (3 * bendY - gainY) / h;
  qx[3] = (gainX - 2 * bendX) / (h * h);
  qy[3] = (gainY - 2 * bendY) / (h * h);
};

/** The same with the acceleration at the start of the step, as a quadratic: for Euler and Verlet. */
export const dragQuadratic: DragStep = (qx, qy, ax, ay, _degree, kappa, chase) => {
  const own = chase ? 1 : 0;
  drag(ax[0] - own * qx[0], ay[0] - own * qy[0], kappa, 0);
  qx[2] = a[0] / 2;
  qy[2] = a[1] / 2;
};
