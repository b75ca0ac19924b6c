import type { Level } from '../../schema/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';

/** Her place and velocity, then those of the asteroid. */
type State = readonly number[];

/** Steps per second, at least. Near the asteroid they are shorter. */
const RATE = 2000;

/** Largest part of the distance to the asteroid that a step may cover. */
const CLOSE = 0.02;

/**
 * Another program for one asteroid that recoils, held all the time, in a wind that blows everywhere, under a speed limit: the
 * classical Runge-Kutta method for both bodies, in the coordinates of the level. Each axis is free, or held at the limit while
 * her own acceleration along it would increase her velocity. Changes are located by bisection.
 * @returns her place after `seconds`, px
 */
export function limitedFlight(level: Level, seconds: number): { x: number; y: number } {
  const { pull, recoil, speedLimit } = { ...DEFAULT_RULES, ...level.rules };
  const { astronaut, asteroids, winds, range } = level;
  const [rock, wind] = [asteroids[0], winds[0]];
  const kappa = level.recoil ? recoil / (2 * rock.radius) : 0;

  const force = ([x, y, , , rx, ry]: State): [number, number, number, number] => {
    const [dx, dy] = [rx - x, ry - y];
    const d = Math.hypot(dx, dy);
    const strength = pull * (1 / d - 1 / range);
    return [strength * dx + wind.ax, strength * dy + wind.ay, (-kappa * dx) / d, (-kappa * dy) / d];
  };
  const held = [0, 0];
  const rates = (s: State): State => {
    const [ax, ay, bx, by] = force(s);
    return [s[2], s[3], held[0] === 0 ? ax : 0, held[1] === 0 ? ay : 0, s[6], s[7], bx, by];
  };
  const step = (s: State, h: number): State => {
    const moved = (k: State, f: number): State => s.map((v, i) => v + f * k[i]);
    const a = rates(s);
    const b = rates(moved(a, h / 2));
    const c = rates(moved(b, h / 2));
    const e = rates(moved(c, h));
    return s.map((v, i) => v + (h / 6) * (a[i] + 2 * (b[i] + c[i]) + e[i]));
  };
  // below 0 once something changes: a free axis beyond the limit, a held one that is driven back
  const guards = (s: State): number[] => {
    const own = force(s);
    return [0, 1].map((axis) => (held[axis] === 0 ? speedLimit - Math.abs(s[2 + axis]) : held[axis] * own[axis]));
  };

  let s: State = [astronaut.x, astronaut.y, astronaut.vx, astronaut.vy, rock.x, rock.y, 0, 0];
  for (let t = 0; t < seconds; ) {
    const d = Math.hypot(s[0] - s[4], s[1] - s[5]);
    const v = Math.hypot(s[2] - s[6], s[3] - s[7]);
    let h = Math.min(seconds - t, 1 / RATE, (CLOSE * d) / (v + Math.sqrt(pull * d)));
    let next = step(s, h);
    // an axis that is driven back exceeds the limit by rounding at most
    const changed = guards(next).map((g, axis) => g < 0 && (held[axis] !== 0 || force(next)[axis] * next[2 + axis] > 0));
    if (changed.includes(true)) {
      let [low, high] = [0, h];
      for (let n = 0; n < 60; n++) {
        const middle = (low + high) / 2;
        const there = step(s, middle);
        if (guards(there).some((g, axis) => changed[axis] && g < 0)) high = middle;
        else low = middle;
      }
      h = high;
      next = step(s, h);
      for (const axis of [0, 1]) {
        if (!changed[axis] || guards(next)[axis] >= 0) continue;
        held[axis] = held[axis] === 0 ? Math.sign(next[2 + axis]) : 0;
        next = next.map((value, i) => (i === 2 + axis && held[axis] !== 0 ? held[axis] * speedLimit : value));
      }
    }
    s = next;
    t += h;
  }
  return { x: s[0], y: s[1] };
}
