import { eulerStep, rungeKuttaEnd, verletEnd } from './fixed-step.ts';
import { CENTRAL, type Flow, LINEAR } from './flow.ts';
import { ontoLine } from './line.ts';
import { pairAt } from './polynomial.ts';

/** Many whole steps in a row, see {@link Integrator.glide}; `count[0]` grows by the steps made. */
export type Glide = (
  flow: Flow,
  x: Float64Array,
  y: Float64Array,
  start: number,
  end: number,
  rate: number,
  count: Int32Array,
) => number;

/** Largest part of the distance to the centre that a fixed step may cover near it. */
const CLOSE_PASS = 0.1;

/** The length of a step: near the centre of the force it covers at most a part of the distance to it. */
export function closePass(flow: Flow, x: Float64Array, y: Float64Array, longest: number): number {
  return flow.kind === CENTRAL ? stepNear(x[0], y[0], x[1], y[1], Math.abs(flow.alpha), longest) : longest;
}

function stepNear(x: number, y: number, vx: number, vy: number, alpha: number, longest: number): number {
  const d2 = x * x + y * y;
  const v2 = vx * vx + vy * vy;
  // (v + w)^2 <= 2 v^2 + 2 w^2: far away no root is needed
  const far = CLOSE_PASS * CLOSE_PASS * d2 - 2 * v2 * longest * longest;
  if (far > 0 && far * far > 4 * alpha * alpha * d2 * longest * longest * longest * longest) return longest;
  const d = Math.sqrt(d2);
  return Math.min(longest, (CLOSE_PASS * d) / (Math.sqrt(v2) + Math.sqrt(alpha * d)));
}

/** To the next point of the grid of `rate`; a point that `start` has all but reached counts as reached. */
export function untilGrid(start: number, rate: number): number {
  return (Math.floor(start * rate + 1e-7) + 1) / rate - start;
}

const end4 = new Float64Array(4);

type Whole = (flow: Flow, x: Float64Array, y: Float64Array, h: number, out: Float64Array) => void;

/** A whole step of semi-implicit Euler. */
export const eulerWhole: Whole = (flow, x, y, h, out) => {
  eulerStep(flow, x, y, h);
  pairAt(x, y, 2, h, out, 0);
};

/** The plain way: step after step. */
export function glideBy(whole: Whole): Glide {
  return (flow, x, y, start, end, rate, count) => {
    let time = start;
    for (;;) {
      const h = closePass(flow, x, y, untilGrid(time, rate));
      if (!(time + h <= end)) return time;
      if (flow.kind === LINEAR) flow.moveTo(x[0], y[0]);
      whole(flow, x, y, h, end4);
      if (flow.kind === LINEAR) ontoLine(flow.steep, flow.slope, end4, 0);
      x[0] = end4[0];
      y[0] = end4[1];
      x[1] = end4[2];
      y[1] = end4[3];
      time += h;
      count[0]++;
    }
  };
}

const plainVerlet = glideBy(verletEnd);
const plainRungeKutta = glideBy(rungeKuttaEnd);

/** Verlet about a centre: the acceleration at the end of a step is the one at the start of the next. */
export const glideVerlet: Glide = (flow, xs, ys, start, end, rate, count) => {
  if (flow.kind !== CENTRAL || !flow.freeX || !flow.freeY) return plainVerlet(flow, xs, ys, start, end, rate, count);
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
    if (!(time + h <= end)) break;
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

/** Runge-Kutta about a centre, {@link rungeKuttaEnd} written out on local numbers. */
export const glideRungeKutta: Glide = (flow, xs, ys, start, end, rate, count) => {
  if (flow.kind !== CENTRAL || !flow.freeX || !flow.freeY) return plainRungeKutta(flow, xs, ys, start, end, rate, count);
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
    if (!(time + h <= end)) break;
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
