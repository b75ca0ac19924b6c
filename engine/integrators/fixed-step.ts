import { CENTRAL, type Flow, type Glide, type Integrator, isInCentre, LINEAR, ontoLine, valueAt } from '../motion/index.ts';

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
  arrive: Integrator['arrive'],
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
        if (kappa > 0) drag(px, py, x, y, degree, kappa, false, h, true);
        else for (let k = 2; k <= degree; k++) px[k] = py[k] = 0;
      }
      return h;
    },
    tolerance: 0,
    chase(qx, qy, ax, ay, kappa, h, recoils) {
      drag(qx, qy, ax, ay, degree, kappa, true, h, recoils);
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
    arrive,
    glide,
  };
}

/** Largest part of the distance to the centre that a fixed step may cover near it. */
const CLOSE_PASS = 0.1;

/** The length of a step: near the centre of the force it covers only a part of the distance to it. */
function closePass(flow: Flow, x: Float64Array, y: Float64Array, longest: number): number {
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

// working memory: accelerations at the stages, and what a step adds
const a = new Float64Array(8);
const gain = new Float64Array(4);

/**
 * Advances a body that is dragged by another one: q'' = kappa d / |d|, with d read from a known piece. `recoils` says that it
 * is the target and no chaser.
 */
type DragStep = (
  qx: Float64Array,
  qy: Float64Array,
  ax: Float64Array,
  ay: Float64Array,
  degree: number,
  kappa: number,
  chase: boolean,
  h: number,
  recoils: boolean,
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

/**
 * The same with constant acceleration. For a target that recoils it is that after `part` of the step: half of it makes second
 * order. For chasers it is that at the start, which is first order.
 */
const dragQuadratic =
  (part: number): DragStep =>
  (qx, qy, ax, ay, degree, kappa, chase, h, recoils) => {
    const own = chase ? 1 : 0;
    const t = recoils ? part * h : 0;
    drag(valueAt(ax, degree, t) - own * (qx[0] + qx[1] * t), valueAt(ay, degree, t) - own * (qy[0] + qy[1] * t), kappa, 0);
    qx[2] = a[0] / 2;
    qy[2] = a[1] / 2;
  };

export const dragByStart = dragQuadratic(0);
export const dragByMiddle = dragQuadratic(1 / 2);

/**
 * The cubic of a step of length `h`, from what the step adds to straight motion. Working with the differences loses no digits.
 * @param gain - what the step adds to the place, x and y, and to the velocity, x and y
 */
export function cubicFrom(gain: Float64Array, x: Float64Array, y: Float64Array, h: number): void {
  const bendX = gain[0] / h;
  const bendY = gain[1] / h;
  x[2] = (3 * bendX - gain[2]) / h;
  y[2] = (3 * bendY - gain[3]) / h;
  x[3] = (gain[2] - 2 * bendX) / (h * h);
  y[3] = (gain[3] - 2 * bendY) / (h * h);
}

const end4 = new Float64Array(4);

/** A whole step of `h` s: writes place and velocity at its end to out[0..3]. */
export type Whole = (flow: Flow, x: Float64Array, y: Float64Array, h: number, out: Float64Array) => void;

/** Glides by making one step after the other. */
export function glideBy(whole: Whole): Glide {
  return (flow, x, y, start, end, rate, count) => {
    let time = start;
    for (;;) {
      const h = closePass(flow, x, y, untilGrid(time, rate));
      // a step so short that it does not change the time would not end by `end`
      if (!(time + h <= end && time + h > time) || isInCentre(flow, x, y)) return time;
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
