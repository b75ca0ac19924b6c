import { CENTRAL, type Flow } from '../motion/index.ts';

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
