import { DEFAULT_RULES, type Level } from '../../schema/index.ts';

/** Her place on the rim (px), her speed along it (px/s) and the place of the target, `time` s after the slide began. */
export interface Slid {
  readonly time: number;
  /** Whether she leaves the rim at that time. */
  readonly off: boolean;
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
  readonly rock: readonly [x: number, y: number];
}

/** The angle on the rim and its rate; the place and velocity of the first asteroid. */
type State = readonly [angle: number, turn: number, x: number, y: number, vx: number, vy: number];

/**
 * A slide from the start along the rim of the first field, by the angle only: angle'' = s f / radius, with f the force outside
 * along the rim and s the share of the time during which it acts. Classical Runge-Kutta in tiny steps; shorter and shorter ones
 * locate the moment she leaves the rim, when the force outside no longer exceeds the centrifugal one.
 * @param between what pushes her in from outside: the gun, or the second field
 */
export function slideByAngle(level: Level, until: number, between: 'gun' | 'fields' = 'gun', step = 2e-3): Slid {
  const { x: cx, y: cy, radius } = level.repulsors[0];
  const { astronaut, asteroids, range } = level;
  const kappa = level.recoil ? 1 / (2 * asteroids[0].radius) : 0;
  const forces = (q: State) => {
    const [c, s] = [Math.cos(q[0]), Math.sin(q[0])];
    const [x, y] = [cx + radius * c, cy + radius * s];
    const [wx, wy] = [q[2] - x, q[3] - y];
    const d = Math.sqrt(wx * wx + wy * wy);
    const pull = DEFAULT_RULES.pull * (1 / d - 1 / range);
    let [fx, fy] = [pull * wx, pull * wy];
    if (between === 'fields') {
      const other = level.repulsors[1];
      const push = DEFAULT_RULES.push / Math.hypot(x - other.x, y - other.y);
      [fx, fy] = [push * (x - other.x), push * (y - other.y)];
    }
    const drawn = -kappa / d;
    return { out: fx * c + fy * s, along: fy * c - fx * s, flies: radius * q[1] * q[1], dx: drawn * wx, dy: drawn * wy };
  };
  const presses = (q: State): number => {
    const { out, flies } = forces(q);
    return -out - flies;
  };
  const rate = (q: State): State => {
    const { out, along, flies, dx, dy } = forces(q);
    return [q[1], (((DEFAULT_RULES.push + flies) / (DEFAULT_RULES.push - out)) * along) / radius, q[4], q[5], dx, dy];
  };
  // written out, because the tests take millions of steps
  const plus = (q: State, h: number, d: State): State => [
    q[0] + h * d[0],
    q[1] + h * d[1],
    q[2] + h * d[2],
    q[3] + h * d[3],
    q[4] + h * d[4],
    q[5] + h * d[5],
  ];
  const advanced = (q: State, h: number): State => {
    const a = rate(q);
    const b = rate(plus(q, h / 2, a));
    const c = rate(plus(q, h / 2, b));
    const d = rate(plus(q, h, c));
    return plus(plus(plus(plus(q, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  };
  const start = Math.atan2(astronaut.y - cy, astronaut.x - cx);
  const turn = (astronaut.vy * Math.cos(start) - astronaut.vx * Math.sin(start)) / radius;
  let q: State = [start, turn, asteroids[0].x, asteroids[0].y, 0, 0];
  let time = 0;
  let off = false;
  for (let h = step; time < until && h > 1e-14; ) {
    const next = advanced(q, Math.min(h, until - time));
    const lost = presses(next) < 0;
    if (!lost) {
      q = next;
      time += Math.min(h, until - time);
    }
    off ||= lost;
    // once it is known that she leaves, the steps only get shorter
    if (off) h /= 2;
  }
  const [c, s] = [Math.cos(q[0]), Math.sin(q[0])];
  const v = radius * q[1];
  return { time, off, x: cx + radius * c, y: cy + radius * s, vx: -v * s, vy: v * c, rock: [q[2], q[3]] };
}
