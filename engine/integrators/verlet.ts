import { CENTRAL, type Flow, type Glide } from '../motion/index.ts';
import { HEAD_ON } from '../tolerances.ts';
import { dragByMiddle, fixedStep, glideBy, stepNear, untilGrid } from './fixed-step.ts';

// working memory: accelerations at both ends
const a = new Float64Array(4);

/** Velocity Verlet: x = x0 + v0 t + a0 t^2 / 2. */
function verletStep(flow: Flow, x: Float64Array, y: Float64Array): void {
  flow.accelerate(x[0], y[0], a, 0);
  x[2] = a[0] / 2;
  y[2] = a[1] / 2;
}

/** Place and velocity after `t` of a Verlet step; the velocity follows from the mean of the accelerations at both ends. */
function verletEnd(flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array): void {
  flow.accelerate(x[0], y[0], a, 0);
  out[0] = ((a[0] / 2) * t + x[1]) * t + x[0];
  out[1] = ((a[1] / 2) * t + y[1]) * t + y[0];
  flow.accelerate(out[0], out[1], a, 2);
  out[2] = x[1] + (a[0] / 2 + a[2] / 2) * t;
  out[3] = y[1] + (a[1] / 2 + a[3] / 2) * t;
}

const plainVerlet = glideBy(verletEnd);

/** Many Verlet steps about a centre: the acceleration at the end of one step is that at the start of the next. */
const glideVerlet: Glide = (flow, xs, ys, start, end, rate, count) => {
  if (flow.kind !== CENTRAL || !flow.freeX || !flow.freeY || flow.isSteady)
    return plainVerlet(flow, xs, ys, start, end, rate, count);
  const { alpha, beta } = flow;
  const strength = Math.abs(alpha);
  let time = start;
  let x = xs[0];
  let y = ys[0];
  let vx = xs[1];
  let vy = ys[1];
  let f = alpha / Math.sqrt(x * x + y * y) + beta;
  let ax = (f * x) / 2;
  let ay = (f * y) / 2;
  let steps = 0;
  for (;;) {
    const h = stepNear(x, y, vx, vy, strength, untilGrid(time, rate));
    if (!(time + h <= end && time + h > time) || x * x + y * y < HEAD_ON * HEAD_ON) break;
    x = (ax * h + vx) * h + x;
    y = (ay * h + vy) * h + y;
    f = alpha / Math.sqrt(x * x + y * y) + beta;
    const bx = (f * x) / 2;
    const by = (f * y) / 2;
    vx = vx + (ax + bx) * h;
    vy = vy + (ay + by) * h;
    ax = bx;
    ay = by;
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

/** Velocity Verlet: second order. */
export const verlet = fixedStep(2, 1, false, verletStep, dragByMiddle, verletEnd, glideVerlet);
