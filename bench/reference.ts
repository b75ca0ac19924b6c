import { DEFAULT_RULES, type Hold, type Level } from '../schema/index.ts';

type State = [x: number, y: number, vx: number, vy: number];

/**
 * Her state at the end of a script in continuous time, by a method that shares nothing with the engine: 4th-order Runge-Kutta
 * with one target per step. A step in which the nearest asteroid changes is cut there, by bisection. Contacts end nothing.
 * @param rate - steps per second, a multiple of 60, so that presses and releases fall between steps
 * @throws {RangeError} for a level with more than asteroids, novae and minerals
 */
export function referenceEnd(level: Level, holds: readonly Hold[], seconds: number, rate: number): Float64Array {
  const other = [level.aliens, level.repulsors, level.winds, level.wormholes].some((list) => list.length > 0);
  if (level.recoil || level.rules !== undefined || other) {
    throw new RangeError(`expected a level of asteroids, novae and minerals, found more in '${level.name}'`);
  }
  if (rate % 60 !== 0) throw new RangeError(`expected a rate that is a multiple of 60, found ${rate}`);
  const targets = level.asteroids;
  const nearest = (s: State): number => {
    let best = Number.POSITIVE_INFINITY;
    let index = 0;
    for (let i = 0; i < targets.length; i++) {
      const dx = targets[i].x - s[0];
      const dy = targets[i].y - s[1];
      if (dx * dx + dy * dy < best) {
        best = dx * dx + dy * dy;
        index = i;
      }
    }
    return index;
  };
  const flow = (s: State, target: number, out: State): void => {
    const dx = targets[target].x - s[0];
    const dy = targets[target].y - s[1];
    const pull = DEFAULT_RULES.pull * (1 / Math.sqrt(dx * dx + dy * dy) - 1 / level.range);
    out[0] = s[2];
    out[1] = s[3];
    out[2] = pull * dx;
    out[3] = pull * dy;
  };
  const k: State[] = [0, 1, 2, 3].map((): State => [0, 0, 0, 0]);
  const at: State = [0, 0, 0, 0];
  const shifted = (s: State, slope: State, h: number): State => {
    for (let i = 0; i < 4; i++) at[i] = s[i] + h * slope[i];
    return at;
  };
  const step = (s: State, target: number, h: number): State => {
    flow(s, target, k[0]);
    flow(shifted(s, k[0], h / 2), target, k[1]);
    flow(shifted(s, k[1], h / 2), target, k[2]);
    flow(shifted(s, k[2], h), target, k[3]);
    return s.map((v, i) => v + (h / 6) * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i])) as State;
  };
  const pulled = (from: State, length: number): State => {
    let s = from;
    let left = length;
    let target = nearest(s);
    while (left > 0) {
      const next = step(s, target, left);
      if (nearest(next) === target) return next;
      let low = 0;
      let high = left;
      while (high - low > 1e-15) {
        const middle = (low + high) / 2;
        if (middle === low || middle === high) break;
        if (nearest(step(s, target, middle)) === target) low = middle;
        else high = middle;
      }
      s = step(s, target, high);
      left -= high;
      target = nearest(s);
    }
    return s;
  };

  const { x, y, vx, vy } = level.astronaut;
  let s: State = [x, y, vx, vy];
  const perTick = rate / 60;
  const ticks = Math.round(seconds * 60);
  for (let tick = 0; tick < ticks; tick++) {
    const held = holds.some(([press, release]) => press <= tick && tick < release);
    if (!held) s = [s[0] + s[2] / 60, s[1] + s[3] / 60, s[2], s[3]];
    else for (let i = 0; i < perTick; i++) s = pulled(s, 1 / rate);
  }
  return Float64Array.from(s);
}
