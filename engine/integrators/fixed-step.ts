import type { Flow, Glide, Integrator } from '../motion/index.ts';
import type { DragStep } from './drag.ts';
import { closePass } from './step-near.ts';

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
