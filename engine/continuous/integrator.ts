import type { Accuracy } from '../accuracy.ts';
import {
  type DragStep,
  dragQuadratic,
  dragRungeKutta,
  eulerStep,
  rungeKuttaEnd,
  rungeKuttaStep,
  verletEnd,
  verletStep,
} from './fixed-step.ts';
import { type Flow, LINEAR } from './flow.ts';
import { closePass, eulerWhole, type Glide, glideBy, glideRungeKutta, glideVerlet } from './glide.ts';
import { pairAt } from './polynomial.ts';
import { centralSeries, chaserSeries, linearSeries, TAYLOR_DEGREE, taylorStep } from './taylor.ts';

/**
 * A way to turn a flow into polynomial pieces. Series hold place and velocity in [0..1] on entry; lengths in s, px.
 */
export interface Integrator {
  readonly degree: number;
  /** Force evaluations a piece costs, for the account of work. */
  readonly evaluations: number;
  /**
   * Expands the astronaut's motion, and the recoiling base's where there is one.
   * @param longest how far the piece may reach; Infinity when nothing says
   * @returns the length for which the piece holds
   */
  expand(
    flow: Flow,
    x: Float64Array,
    y: Float64Array,
    longest: number,
    px: Float64Array | null,
    py: Float64Array | null,
    kappa: number,
  ): number;
  /** Expands a body that accelerates at `kappa` towards the place (ax, ay); returns the length for which it holds. */
  chase(qx: Float64Array, qy: Float64Array, ax: Float64Array, ay: Float64Array, kappa: number, h: number): number;
  /** Bound on |u''| over the piece. */
  acceleration(flow: Flow, x: Float64Array, y: Float64Array, h: number): number;
  /** Place and velocity after `t` of an expanded piece, into out[0..3]. */
  settle(flow: Flow, x: Float64Array, y: Float64Array, t: number, out: Float64Array): void;
  /**
   * Makes whole steps of the grid of `rate` from `start` while they end by `end`: place and velocity in x[0..1], y[0..1]
   * become the bits that `expand` and `settle` would give, without the pieces. null where there are no fixed steps.
   * @returns the time reached
   */
  readonly glide: Glide | null;
}

/** A Taylor piece in accelerated flow is cut here, so that bounds over it stay tight, s. */
const LONGEST_TAYLOR = 4;

/**
 * Largest part of the time to the centre that a Taylor piece may reach. The series' singularity lies at the complex time
 * at which u.u = 0, no nearer than she could be at the centre; a pass too close for the last terms to show it must not be
 * stepped over.
 */
export const CONVERGENCE = 0.6;

/** The least time in which she can be at the centre of a force of strength `alpha`, s. */
function timeToCentre(x: Float64Array, y: Float64Array, alpha: number): number {
  const d = Math.sqrt(x[0] * x[0] + y[0] * y[0]);
  const v2 = x[1] * x[1] + y[1] * y[1];
  return (2 * d) / (Math.sqrt(v2) + Math.sqrt(v2 + 2 * Math.abs(alpha) * d));
}

function taylor(tolerance: number): Integrator {
  return {
    degree: TAYLOR_DEGREE,
    evaluations: 1,
    expand(flow, x, y, longest, px, py, kappa) {
      if (flow.kind === LINEAR) {
        linearSeries(x, y, flow.ax, flow.ay, flow.beta);
        return taylorStep(x, y, tolerance, Math.min(longest, LONGEST_TAYLOR));
      }
      centralSeries(x, y, flow.alpha, flow.beta, flow.freeX, flow.freeY, px, py, kappa);
      return taylorStep(x, y, tolerance, Math.min(longest, LONGEST_TAYLOR, CONVERGENCE * timeToCentre(x, y, flow.alpha)));
    },
    chase(qx, qy, ax, ay, kappa, h) {
      chaserSeries(qx, qy, ax, ay, kappa);
      return taylorStep(qx, qy, tolerance, Math.min(h, LONGEST_TAYLOR));
    },
    acceleration(flow, x, y, h) {
      const alpha = Math.abs(flow.alpha);
      if (flow.alpha > 0) return alpha;
      // a pull weakens with distance while she is in range; `beta d` may win only beyond it
      const d = Math.sqrt(x[0] * x[0] + y[0] * y[0]) + (Math.sqrt(x[1] * x[1] + y[1] * y[1]) + alpha * h) * h;
      return Math.max(alpha, flow.beta * d);
    },
    settle(_flow, x, y, t, out) {
      pairAt(x, y, TAYLOR_DEGREE, t, out, 0);
    },
    glide: null,
  };
}

type Step = (flow: Flow, x: Float64Array, y: Float64Array, h: number) => void;

function fixedStep(
  degree: number,
  evaluations: number,
  step: Step,
  drag: DragStep,
  settle: Integrator['settle'],
  glide: Glide,
): Integrator {
  return {
    degree,
    evaluations,
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

const euler = fixedStep(2, 1, eulerStep, dragQuadratic, (_flow, x, y, t, out) => pairAt(x, y, 2, t, out, 0), glideBy(eulerWhole));
const verlet = fixedStep(2, 1, verletStep, dragQuadratic, verletEnd, glideVerlet);
const rungeKutta = fixedStep(3, 4, rungeKuttaStep, dragRungeKutta, rungeKuttaEnd, glideRungeKutta);

/**
 * How much less than the tolerance a single Taylor piece may err: errors of velocity grow with time, and there are many
 * pieces. At 25,000 the energy of an orbit drifts by less than 1e-12 in an hour at the default tolerance.
 */
export const PIECE_SHARE = 25_000;

/** The integrator an accuracy names. */
export function integratorOf(accuracy: Accuracy): Integrator {
  switch (accuracy.integrator) {
    case 'euler':
      return euler;
    case 'verlet':
      return verlet;
    case 'rk4':
      return rungeKutta;
    case 'taylor':
      return taylor((accuracy.tolerance ?? 1e-9) / PIECE_SHARE);
    default:
      throw new RangeError(`'${accuracy.integrator}' is not an integrator in continuous time`);
  }
}
