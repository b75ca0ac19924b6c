import fc from 'fast-check';
import { expect, it } from 'vitest';
import { centralSeries, chaserSeries, drivenSeries, TAYLOR_DEGREE } from '../../engine/motion/index.ts';

// Two methods for the same coefficients that share no formula: by the energy, and by plain Cauchy products.

const component = (most: number) => fc.double({ min: -most, max: most, noNaN: true });
const start = fc
  .record({ x: component(500), y: component(500), vx: component(500), vy: component(500) })
  .filter(({ x, y }) => x * x + y * y > 1e-6);
const pull = fc.double({ min: -300, max: -1, noNaN: true });
const push = fc.double({ min: 1, max: 300, noNaN: true });
const force = fc.record({
  alpha: fc.oneof(pull, push),
  // how much of the force at her place, of the opposite sign: all of it at the range
  share: fc.double({ min: 0, max: 1, noNaN: true }),
  kappa: fc.double({ min: 1e-3, max: 100, noNaN: true }),
});

const series = (a: number, b: number): Float64Array => {
  const c = new Float64Array(TAYLOR_DEGREE + 1);
  c[0] = a;
  c[1] = b;
  return c;
};

it('gives the coefficients that plain products give', () => {
  fc.assert(
    fc.property(start, force, ({ x, y, vx, vy }, { alpha, share, kappa }) => {
      const d = Math.hypot(x, y);
      const beta = (-share * alpha) / d;
      const [x1, y1, x2, y2] = [series(x, vx), series(y, vy), series(x, vx), series(y, vy)];
      const [p1, q1, p2, q2] = [series(1, 2), series(3, 4), series(1, 2), series(3, 4)];
      centralSeries(x1, y1, alpha, beta, p1, q1, kappa);
      const flow = { alpha, beta, freeX: true, freeY: true, steadyX: 0, steadyY: 0, isSteady: false };
      drivenSeries(x2, y2, flow, p2, q2, kappa);
      // as a series converges: the k-th coefficient matters in proportion to the k-th power of the time to the centre
      const v = Math.hypot(vx, vy);
      const time = (2 * d) / (v + Math.sqrt(v * v + 2 * Math.abs(alpha) * d));
      for (let k = 0; k <= TAYLOR_DEGREE; k++) {
        const reach = (0.6 * time) ** k;
        const size = 1e-11 * (d + Math.abs(alpha) * time * time);
        expect(Math.abs(x1[k] - x2[k]) * reach).toBeLessThanOrEqual(size);
        expect(Math.abs(y1[k] - y2[k]) * reach).toBeLessThanOrEqual(size);
        const sizeOfBase = 1e-11 * (kappa * time * time);
        expect(k < 2 ? p1[k] - p2[k] : Math.abs(p1[k] - p2[k]) * reach).toBeLessThanOrEqual(sizeOfBase);
        expect(k < 2 ? q1[k] - q2[k] : Math.abs(q1[k] - q2[k]) * reach).toBeLessThanOrEqual(sizeOfBase);
      }
    }),
  );
});

it('follows a circle if the pull keeps her on it', () => {
  fc.assert(
    fc.property(fc.double({ min: 1, max: 500, noNaN: true }), pull, (r, alpha) => {
      const omega = Math.sqrt(-alpha / r);
      const [x, y] = [series(r, 0), series(0, r * omega)];
      centralSeries(x, y, alpha, 0, null, null, 0);
      // r cos(omega t), r sin(omega t)
      let c = r;
      for (let k = 1; k <= TAYLOR_DEGREE; k++) {
        c *= omega / k;
        const sign = k % 4 < 2 ? 1 : -1;
        const [even, odd] = k % 2 === 0 ? [sign * c, 0] : [0, sign * c];
        expect(Math.abs(x[k] - even)).toBeLessThanOrEqual(1e-9 * c);
        expect(Math.abs(y[k] - odd)).toBeLessThanOrEqual(1e-9 * c);
      }
    }),
  );
});

/** The series of q'' = kappa (a - q) / |a - q| by plain Cauchy products: s = e.e, w = s^(-1/2) from s w' = -s' w / 2, and e w. */
function plainChase(qx: Float64Array, qy: Float64Array, ax: Float64Array, ay: Float64Array, kappa: number): void {
  const [ex, ey, s, w] = [series(0, 0), series(0, 0), series(0, 0), series(0, 0)];
  for (let n = 0; n <= TAYLOR_DEGREE - 2; n++) {
    ex[n] = ax[n] - qx[n];
    ey[n] = ay[n] - qy[n];
    let [sn, wn, zx, zy] = [0, 0, 0, 0];
    for (let k = 0; k <= n; k++) sn += ex[k] * ex[n - k] + ey[k] * ey[n - k];
    s[n] = sn;
    for (let k = 1; k <= n; k++) wn += (k / 2 - n) * s[k] * w[n - k];
    w[n] = n === 0 ? 1 / Math.sqrt(sn) : wn / (n * s[0]);
    for (let k = 0; k <= n; k++) {
      zx += w[n - k] * ex[k];
      zy += w[n - k] * ey[k];
    }
    qx[n + 2] = (kappa * zx) / ((n + 1) * (n + 2));
    qy[n + 2] = (kappa * zy) / ((n + 1) * (n + 2));
  }
}

it('gives the same as plain products for a body that chases', () => {
  const orbit = fc.record({ r: component(300), alpha: pull, vy: component(200) }).filter(({ r }) => Math.abs(r) > 10);
  fc.assert(
    fc.property(orbit, start, fc.double({ min: 1, max: 60, noNaN: true }), ({ r, alpha, vy }, { x, y, vx, vy: v }, kappa) => {
      const [ax, ay] = [series(r, 0), series(0, vy)];
      centralSeries(ax, ay, alpha, 0, null, null, 0);
      const [x1, y1, x2, y2] = [series(r + x, vx), series(y, v), series(r + x, vx), series(y, v)];
      chaserSeries(x1, y1, ax, ay, kappa);
      plainChase(x2, y2, ax, ay, kappa);
      // until they can meet, and until the chased body can be at its own centre
      const d = Math.hypot(x, y);
      const fast = Math.hypot(vx, v - vy);
      const meet = (2 * d) / (fast + Math.sqrt(fast * fast + 2 * (kappa - alpha) * d));
      const fall = (2 * Math.abs(r)) / (Math.abs(vy) + Math.sqrt(vy * vy - 2 * alpha * Math.abs(r)));
      const time = Math.min(meet, fall);
      for (let k = 2; k <= TAYLOR_DEGREE; k++) {
        const reach = (0.6 * time) ** k;
        expect(Math.abs(x1[k] - x2[k]) * reach).toBeLessThanOrEqual(1e-11 * kappa * time * time);
        expect(Math.abs(y1[k] - y2[k]) * reach).toBeLessThanOrEqual(1e-11 * kappa * time * time);
      }
    }),
  );
});

it('does not divide by a distance of 0', () => {
  const [qx, qy] = [series(1, 2), series(3, 4)];
  qx[5] = 7;
  chaserSeries(qx, qy, series(1 + 1e-7, 0), series(3, 0), 10);
  expect([...qx, ...qy]).toEqual([...series(1, 2), ...series(3, 4)]);
});
