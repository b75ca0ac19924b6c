import { CENTRAL, type Flow, type Glide } from '../motion/index.ts';
import { HEAD_ON } from '../tolerances.ts';
import { cubicFrom, dragRungeKutta, fixedStep, glideBy, stepNear, untilGrid } from './fixed-step.ts';

// working memory: accelerations at the stages, and what a step adds
const a = new Float64Array(2);
const gain = new Float64Array(4);
const unused = new Float64Array(4);

/**
 * Classical 4th-order Runge-Kutta for x'' = f(x): writes place and velocity after `h` to out[0..3]. Leaves in `gain` what the
 * step adds: to the place beyond h v0, and to the velocity.
 */
function rungeKuttaEnd(flow: Flow, x: Float64Array, y: Float64Array, h: number, out: Float64Array): void {
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

/** The same step as a cubic that has the step's place and velocity at both ends. */
function rungeKuttaStep(flow: Flow, x: Float64Array, y: Float64Array, h: number): void {
  rungeKuttaEnd(flow, x, y, h, unused);
  cubicFrom(gain, x, y, h);
}

const plainRungeKutta = glideBy(rungeKuttaEnd);

/** Many Runge-Kutta steps about a centre: {@link rungeKuttaEnd} written out with local variables. */
const glideRungeKutta: Glide = (flow, xs, ys, start, end, rate, count) => {
  if (flow.kind !== CENTRAL || !flow.freeX || !flow.freeY || flow.isSteady)
    return plainRungeKutta(flow, xs, ys, start, end, rate, count);
  const { alpha, beta } = flow;
  const strength = Math.abs(alpha);
  let time = start;
  let x = xs[0];
  let y = ys[0];
  let vx = xs[1];
  let vy = ys[1];
  let steps = 0;
  for (;;) {
    const h = stepNear(x, y, vx, vy, strength, untilGrid(time, rate));
    if (!(time + h <= end && time + h > time) || x * x + y * y < HEAD_ON * HEAD_ON) break;
    const half = h / 2;
    const quarter = half * half;
    let f = alpha / Math.sqrt(x * x + y * y) + beta;
    const ax = f * x;
    const ay = f * y;
    const middleX = x + half * vx;
    const middleY = y + half * vy;
    f = alpha / Math.sqrt(middleX * middleX + middleY * middleY) + beta;
    const bx = f * middleX;
    const by = f * middleY;
    let px = middleX + quarter * ax;
    let py = middleY + quarter * ay;
    f = alpha / Math.sqrt(px * px + py * py) + beta;
    const cx = f * px;
    const cy = f * py;
    px = x + h * vx + 2 * quarter * bx;
    py = y + h * vy + 2 * quarter * by;
    f = alpha / Math.sqrt(px * px + py * py) + beta;
    const sixth = h / 6;
    x = x + (h * vx + sixth * h * (ax + bx + cx));
    y = y + (h * vy + sixth * h * (ay + by + cy));
    vx = vx + sixth * (ax + 2 * (bx + cx) + f * px);
    vy = vy + sixth * (ay + 2 * (by + cy) + f * py);
    time += h;
    steps++;
  }
  xs[0] = x;
  ys[0] = y;
  xs[1] = vx;
  ys[1] = vy;
  count[0] += steps;
  return time;
};

/** Classical 4th-order Runge-Kutta. */
export const rk4 = fixedStep(3, 4, false, rungeKuttaStep, dragRungeKutta, rungeKuttaEnd, glideRungeKutta);
