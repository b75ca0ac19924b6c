import { DEFAULT_RULES } from '../../schema/index.ts';

/** An orbit around one asteroid between its smallest and its largest distance. */
export interface Orbit {
  /** The speed at the farthest point, at right angles to the line to the centre, px/s. */
  readonly speed: number;
  /** The time from one farthest point to the next, s. */
  readonly period: number;
  /** The angle about the centre from one farthest point to the next, radians. */
  readonly turn: number;
}

/** Simpson's rule over n (even) equal parts. */
function simpson(f: (x: number) => number, from: number, to: number, n: number): number {
  const h = (to - from) / n;
  let sum = f(from) + f(to);
  for (let i = 1; i < n; i++) sum += (i % 2 === 1 ? 4 : 2) * f(from + i * h);
  return (sum * h) / 3;
}

/**
 * Period and turn of an orbit by the integrals over the distance r, with U = A (r - r^2 / (2 range)) and angular momentum L:
 * vr^2 = 2 (U(far) - U(r)) + L^2 (1 / far^2 - 1 / r^2), which is (r - near) times a factor without cancellation, and
 * (far - r) times another. The near half is integrated over r = near cosh u, the far half over r = far - w^2: smooth, however
 * close the pass.
 * @param near, far distances, px; 0 < near < far
 */
export function orbitByQuadrature(near: number, far: number, range: number): Orbit {
  const a = DEFAULT_RULES.pull;
  const l = near * far * Math.sqrt((2 * a * (1 - (near + far) / (2 * range))) / (near + far));
  const bowl = (r: number, apsis: number) => 2 * a * (1 - (r + apsis) / (2 * range));
  const lift = (r: number, apsis: number) => (l / (r * apsis)) ** 2 * (r + apsis);
  const middle = (near + far) / 2;
  // d t per d u: r - near = 2 near sinh^2(u / 2), dr = near sinh u du
  const inner = (u: number) => {
    const r = near * Math.cosh(u);
    return (Math.sqrt(2 * near) * Math.cosh(u / 2)) / Math.sqrt(lift(r, near) - bowl(r, near));
  };
  const outer = (w: number) => 2 / Math.sqrt(bowl(far - w * w, far) - lift(far - w * w, far));
  const last = Math.acosh(middle / near);
  const width = Math.sqrt(far - middle);
  const whirl = (r: number) => l / (r * r);
  return {
    speed: l / far,
    period: 2 * (simpson(inner, 0, last, 20_000) + simpson(outer, 0, width, 20_000)),
    turn:
      2 *
      (simpson((u) => inner(u) * whirl(near * Math.cosh(u)), 0, last, 20_000) +
        simpson((w) => outer(w) * whirl(far - w * w), 0, width, 20_000)),
  };
}
