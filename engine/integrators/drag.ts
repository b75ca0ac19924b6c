import { valueAt } from '../motion/index.ts';
import { cubicFrom } from './cubic.ts';

// working memory: accelerations at the stages, and what a step adds
const a = new Float64Array(8);
const gain = new Float64Array(4);

/** Advances a body that is dragged by another one: q'' = kappa d / |d|, with d read from a known piece. */
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
 * Runge-Kutta step of a body q with q'' = kappa d / |d|. If it chases the place a, d = a(t) - q; otherwise a is already
 * relative to the body, and d = a(t).
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
  cubicFrom(gain, qx, qy, h);
};

/** The same with constant acceleration, that at the start of the step: for Euler and Verlet. */
export const dragQuadratic: DragStep = (qx, qy, ax, ay, _degree, kappa, chase) => {
  const own = chase ? 1 : 0;
  drag(ax[0] - own * qx[0], ay[0] - own * qy[0], kappa, 0);
  qx[2] = a[0] / 2;
  qy[2] = a[1] / 2;
};
