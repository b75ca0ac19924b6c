import { CENTRAL, type Flow, type Glide, type Integrator } from '../motion/index.ts';
import type { DragStep } from './drag.ts';

/** Expands her motion over a step of `h` s: writes the coefficients from the second on. */
type Step = (flow: Flow, x: Float64Array, y: Float64Array, h: number) => void;

/**
 * Makes an integrator with fixed steps from four functions: one step, a step of a dragged body, the end of a step, and many
 * steps in a row.
 */
export function fixedStep(
  degree: number,
  evaluations: number,
  kicksFirst: boolean,
  step: Step,
  drag: DragStep,
  settle: Integrator['settle'],
  glide: Glide,
): Integrator {
  return {
    degree,
    evaluations,
    kicksFirst,
    expand(flow, x, y, longest, px, py, kappa) {
      const h = closePass(flow, x, y, longest);
      step(flow, x, y, h);
      if (px !== null && py !== null) {
        if (kappa > 0) drag(px, py, x, y, degree, kappa, false, h);
        else for (let k = 2; k <= degree; k++) px[k] = py[k] = 0;
      }
      return h;
    },
    chase(qx, qy, ax, ay, kappa, h) {
      drag(qx, qy, ax, ay, degree, kappa, true, h);
      return h;
    },
    acceleration(_flow, x, y, h) {
      const c3x = degree > 2 ? 6 * x[3] * h : 0;
      const c3y = degree > 2 ? 6 * y[3] * h : 0;
      const ax = 2 * x[2];
      const ay = 2 * y[2];
      const first = ax * ax + ay * ay;
      const last = (ax + c3x) * (ax + c3x) + (ay + c3y) * (ay + c3y);
      return Math.sqrt(Math.max(first, last));
    },
    settle,
    glide,
  };
}

/** Largest part of the distance to the centre that a fixed step may cover near it. */
const CLOSE_PASS = 0.1;

/** The length of a step: near the centre of the force it covers only a part of the distance to it. */
export function closePass(flow: Flow, x: Float64Array, y: Float64Array, longest: number): number {
  return flow.kind === CENTRAL ? stepNear(x[0], y[0], x[1], y[1], Math.abs(flow.alpha) + flow.steadyStrength, longest) : longest;
}

/** The same for a centre of strength `alpha`, px/s². */
export function stepNear(x: number, y: number, vx: number, vy: number, alpha: number, longest: number): number {
  const d2 = x * x + y * y;
  const v2 = vx * vx + vy * vy;
  // (v + w)^2 <= 2 v^2 + 2 w^2: far away no square root is needed
  const far = CLOSE_PASS * CLOSE_PASS * d2 - 2 * v2 * longest * longest;
  if (far > 0 && far * far > 4 * alpha * alpha * d2 * longest * longest * longest * longest) return longest;
  const d = Math.sqrt(d2);
  return Math.min(longest, (CLOSE_PASS * d) / (Math.sqrt(v2) + Math.sqrt(alpha * d)));
}

/** The time to the next point of the grid of `rate`. A point that `start` has reached up to rounding counts as reached. */
export function untilGrid(start: number, rate: number): number {
  return (Math.floor(start * rate + 1e-7) + 1) / rate - start;
}
