import type { Accuracy } from '../accuracy.ts';
import {
  centralSeries,
  drivenSeries,
  type Integrator,
  LINEAR,
  linearSeries,
  TAYLOR_DEGREE,
  taylorStep,
} from '../motion/index.ts';
import { CONVERGENCE, LONGEST_TAYLOR, PIECE_SHARE } from '../tolerances.ts';

/** Error of position per second if the accuracy has none, px. */
const DEFAULT_TOLERANCE = 1e-9;

/** The least time in which she can reach the centre of a force of strength `alpha`, s. */
function timeToCentre(x: Float64Array, y: Float64Array, alpha: number): number {
  const d = Math.sqrt(x[0] * x[0] + y[0] * y[0]);
  const v2 = x[1] * x[1] + y[1] * y[1];
  return (2 * d) / (Math.sqrt(v2) + Math.sqrt(v2 + 2 * alpha * d));
}

/**
 * Taylor series of degree 16 with error control.
 * @param tolerance - error of a single piece, px
 */
function taylor(tolerance: number): Integrator {
  return {
    degree: TAYLOR_DEGREE,
    evaluations: 1,
    kicksFirst: false,
    expand(flow, x, y, longest, px, py, kappa) {
      if (flow.kind === LINEAR) {
        linearSeries(x, y, flow.ax, flow.ay, flow.beta);
        return taylorStep(x, y, tolerance, Math.min(longest, LONGEST_TAYLOR));
      }
      const { alpha, beta } = flow;
      if (flow.freeX && flow.freeY && !flow.isSteady) centralSeries(x, y, alpha, beta, px, py, kappa);
      else drivenSeries(x, y, flow, px, py, kappa);
      const strength = Math.abs(alpha) + flow.steadyStrength;
      return taylorStep(x, y, tolerance, Math.min(longest, LONGEST_TAYLOR, CONVERGENCE * timeToCentre(x, y, strength)));
    },
    tolerance,
    chase: null,
    acceleration(flow, x, y, h) {
      const steady = flow.steadyStrength;
      const alpha = Math.abs(flow.alpha);
      if (flow.alpha > 0) return alpha + steady;
      // a pull weakens with distance while she is in range; `beta d` can be larger only beyond it
      const d = Math.sqrt(x[0] * x[0] + y[0] * y[0]) + (Math.sqrt(x[1] * x[1] + y[1] * y[1]) + (alpha + steady) * h) * h;
      return Math.max(alpha, flow.beta * d) + steady;
    },
    arrive: null,
    glide: null,
  };
}

/** The integrator of the tolerance that nearly every scene has. */
const usual = /* @__PURE__ */ taylor(DEFAULT_TOLERANCE / PIECE_SHARE);

/** The integrator with error control of an accuracy. */
export function taylorOf({ tolerance }: Accuracy): Integrator {
  return tolerance === null || tolerance === DEFAULT_TOLERANCE ? usual : taylor(tolerance / PIECE_SHARE);
}
