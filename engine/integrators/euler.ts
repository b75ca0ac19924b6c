import { type Flow, pairAt } from '../motion/index.ts';
import { dragQuadratic } from './drag.ts';
import { fixedStep } from './fixed-step.ts';
import { glideBy, type Whole } from './glide.ts';

// working memory: an acceleration
const a = new Float64Array(2);

/** Semi-implicit Euler: v1 = v0 + a0 h, x = x0 + v1 t. */
function eulerStep(flow: Flow, x: Float64Array, y: Float64Array, h: number): void {
  flow.accelerate(x[0], y[0], a, 0);
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
  eulerStep,
  dragQuadratic,
  (_flow, x, y, t, out) => pairAt(x, y, 2, t, out, 0),
  glideBy(eulerWhole),
);
