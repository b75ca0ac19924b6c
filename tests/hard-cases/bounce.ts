import { DEFAULT_RULES, type Level } from '../../schema/index.ts';

type State = readonly [x: number, y: number, vx: number, vy: number];

/**
 * Bounces on the rim of the first field, with the gun held from the start: Runge-Kutta in steps of `step` s on either side.
 * Each crossing of the rim is located by Newton's method, and the integration restarts there. No sliding, no averaging.
 * @returns place and velocity at each of `times`, in order, s
 */
export function bounceByBounce(level: Level, times: readonly number[], step = 5e-6): State[] {
  const { x: cx, y: cy, radius } = level.repulsors[0];
  const [{ x: ax, y: ay }] = level.asteroids;
  const rate = ([x, y, vx, vy]: State, within: boolean): State => {
    if (within) {
      const r = Math.hypot(x, y);
      return [vx, vy, (DEFAULT_RULES.push * x) / r, (DEFAULT_RULES.push * y) / r];
    }
    const [dx, dy] = [ax - cx - x, ay - cy - y];
    const f = DEFAULT_RULES.pull * (1 / Math.hypot(dx, dy) - 1 / level.range);
    return [vx, vy, f * dx, f * dy];
  };
  const plus = (q: State, h: number, d: State): State => [q[0] + h * d[0], q[1] + h * d[1], q[2] + h * d[2], q[3] + h * d[3]];
  const advanced = (q: State, h: number, within: boolean): State => {
    const a = rate(q, within);
    const b = rate(plus(q, h / 2, a), within);
    const c = rate(plus(q, h / 2, b), within);
    const d = rate(plus(q, h, c), within);
    return plus(q, h / 6, [0, 1, 2, 3].map((i) => a[i] + 2 * b[i] + 2 * c[i] + d[i]) as unknown as State);
  };
  const beyond = ([x, y]: State) => Math.hypot(x, y) - radius;
  const { x, y, vx, vy } = level.astronaut;
  let q: State = [x - cx, y - cy, vx, vy];
  let within = q[0] * q[2] + q[1] * q[3] < 0;
  let time = 0;
  return times.map((until) => {
    while (time < until) {
      const h = Math.min(step, until - time);
      let next = advanced(q, h, within);
      let taken = h;
      if (within ? beyond(next) > 0 : beyond(next) < 0) {
        for (let n = 0; n < 6; n++) {
          const r = Math.hypot(next[0], next[1]);
          taken -= beyond(next) / ((next[0] * next[2] + next[1] * next[3]) / r);
          next = advanced(q, taken, within);
        }
        within = !within;
      }
      q = next;
      time += taken;
    }
    return [q[0] + cx, q[1] + cy, q[2], q[3]];
  });
}
