import { type Flow, LINEAR, pairAt } from '../motion/index.ts';
import { dragByStart, fixedStep, glideBy, type Whole } from './fixed-step.ts';

// working memory: an acceleration
const a = new Float64Array(2);

/**
 * Semi-implicit Euler: v1 = v0 + a0 h, x = x0 + v1 t. On a line through the centre a swing may be shorter than a step: such a
 * step would turn her before she moves, in the centre again and again. There it is the parabola x = x0 + v0 t + a0 t^2 / 2.
 */
function eulerStep(flow: Flow, x: Float64Array, y: Float64Array, h: number): void {
  flow.accelerate(x[0], y[0], a, 0);
  const speed = x[1] * x[1] + y[1] * y[1];
  if (flow.kind === LINEAR && speed > 0 && speed + (x[1] * a[0] + y[1] * a[1]) * h <= 0) {
    x[2] = a[0] / 2;
    y[2] = a[1] / 2;
    return;
  }
  x[2] = 0;
  y[2] = 0;
  x[1] += a[0] * h;
  y[1] += a[1] * h;
}

/** A whole step of semi-implicit Euler. */
const eulerWhole: Whole = (flow, x, y, h, out) => {
  eulerStep(flow, x, y, h);
  pairAt(x, y, 2, h, out, 0);
};

/** Semi-implicit Euler: first order. */
export const euler = fixedStep(
  2,
  1,
  true,
  eulerStep,
  dragByStart,
  (_flow, x, y, t, out) => pairAt(x, y, 2, t, out, 0),
  glideBy(eulerWhole),
);
