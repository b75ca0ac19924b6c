import { TICK } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';

/** A scene with everything on one line: places along it, px, and her velocity, px/s. */
export interface LineScene {
  readonly start: number;
  readonly velocity: number;
  readonly range: number;
  readonly recoil: boolean;
  readonly asteroids: readonly { readonly at: number; readonly radius: number }[];
  readonly fields: readonly { readonly at: number; readonly radius: number }[];
}

/** The places of her and the asteroids at the end of each tick, until she is lost or the motion can't be determined. */
export type LineRun = number[][];

/** Steps per tick; a step with an event is halved until the event is located. */
const STEPS = 2;
const HALVINGS = 60;
/** More events than this in a tick mean sliding or very fast swings, which have their own tests. */
const MOST_EVENTS = 40;

/**
 * The game in one dimension, by plain Runge-Kutta steps between events that are found by bisection. It shares only the numbers
 * of the game with the engine. State: her place and velocity, then those of each asteroid.
 * @param held whether the gun is held in a tick
 */
export function moveOnLine(scene: LineScene, ticks: number, held: (tick: number) => boolean): LineRun {
  const { range, recoil, asteroids, fields } = scene;
  let state = [scene.start, scene.velocity, ...asteroids.flatMap(({ at }) => [at, 0])];
  const rock = (s: readonly number[], i: number) => s[2 + 2 * i];
  const inside = fields.map(({ at, radius }) => Math.abs(scene.start - at) < radius);
  let target = -1;
  /** The side of the target, and the centre of the active field; fixed between events. */
  let side = 0;
  let out = 0;
  const field = () => inside.indexOf(true);
  const sideOf = (gap: number, speed: number) => Math.sign(gap) || Math.sign(speed);

  const rates = (s: readonly number[]): number[] => {
    const d: number[] = [s[1], 0];
    for (let i = 0; i < asteroids.length; i++) d.push(s[3 + 2 * i], 0);
    if (field() >= 0) d[1] = out * DEFAULT_RULES.push;
    else if (target >= 0) d[1] = side * DEFAULT_RULES.pull * (1 - (side * (rock(s, target) - s[0])) / range);
    if (recoil && target >= 0) d[3 + 2 * target] = -side / (2 * asteroids[target].radius);
    return d;
  };
  const step = (s: readonly number[], h: number): number[] => {
    const plus = (k: readonly number[], f: number) => s.map((v, i) => v + f * k[i]);
    const a = rates(s);
    const b = rates(plus(a, h / 2));
    const c = rates(plus(b, h / 2));
    const d = rates(plus(c, h));
    return s.map((v, i) => v + (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]));
  };
  // each guard is above 0 until its event happens
  const guards = (s: readonly number[]): number[] => [
    ...fields.map(({ at, radius }, i) => (inside[i] ? 1 : -1) * (radius - Math.abs(s[0] - at))),
    target >= 0 && side !== 0 ? side * (rock(s, target) - s[0]) : 1,
    field() >= 0 ? out * (s[0] - fields[field()].at) : 1,
    ...asteroids.map((_, i) => (target < 0 || i === target ? 1 : Math.abs(rock(s, i) - s[0]) - Math.abs(rock(s, target) - s[0]))),
  ];
  const look = () => {
    if (field() >= 0) out = sideOf(state[0] - fields[field()].at, state[1]);
    if (target >= 0) side = sideOf(rock(state, target) - state[0], state[3 + 2 * target] - state[1]);
  };
  const happen = (guard: number) => {
    if (guard < fields.length) inside[guard] = !inside[guard];
    if (guard >= fields.length + 2) target = guard - fields.length - 2;
    const [oldSide, oldOut] = [side, out];
    look();
    // the sign changes at its own crossing, regardless of rounding
    if (guard === fields.length) side = -oldSide;
    if (guard === fields.length + 1) out = -oldOut;
  };

  const run: LineRun = [];
  for (let tick = 0; tick < ticks; tick++) {
    const distances = asteroids.map((_, i) => Math.abs(rock(state, i) - state[0]));
    target = held(tick) ? distances.indexOf(Math.min(...distances)) : -1;
    look();
    let events = 0;
    for (let n = 0; n < STEPS; n++) {
      let left = TICK / STEPS;
      while (left > 1e-15) {
        const before = guards(state);
        const crossed = (h: number) =>
          guards(step(state, h)).findIndex((g, i) => g < 0 && (before[i] > 1e-12 || g < before[i] - 1e-9));
        let guard = crossed(left);
        if (guard < 0) {
          state = step(state, left);
          break;
        }
        let [low, high] = [0, left];
        for (let k = 0; k < HALVINGS; k++) {
          const middle = (low + high) / 2;
          const found = crossed(middle);
          if (found < 0) low = middle;
          else {
            high = middle;
            guard = found;
          }
        }
        state = step(state, high);
        left -= high;
        happen(guard);
        if (++events > MOST_EVENTS) return run;
      }
    }
    if (Math.min(...asteroids.map((_, i) => Math.abs(rock(state, i) - state[0]))) > range - 1e-3) return run;
    if (Math.abs(state[1]) > 990) return run;
    run.push([state[0], ...asteroids.map((_, i) => rock(state, i))]);
  }
  return run;
}
