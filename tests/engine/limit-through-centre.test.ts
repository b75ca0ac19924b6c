import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate, WorkBudget } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { plainLevel } from './plain-level.ts';

const PULL = 39;

/** Along an axis, and along a diagonal, where both axes reach the limit at once. */
const DIRECTIONS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].map((y) => [x, y] as const)).filter(([x, y]) => x !== 0 || y !== 0);

interface Fall {
  /** From her start to the asteroid's centre, px, and to where the pull ends, px. */
  readonly distance: number;
  readonly range: number;
  /** Towards the centre, px/s: at the start, and at most. */
  readonly speed: number;
  readonly limit: number;
  /** A wind towards the centre, px/s². */
  readonly wind: number;
}

/**
 * The fall in closed form: from rest or less than the limit, at the limit to the very centre, and beyond it pulled back.
 * @param beyond - time after the centre, s
 * @returns how far she is beyond the centre and how fast then, px and px/s; and the time, s. Null if the limit is not reached
 */
function fallThrough({ distance, range, speed, limit, wind }: Fall, beyond: number) {
  const w = Math.sqrt(PULL / range);
  const a = PULL * (1 - distance / range) + wind;
  const fast = (t: number): number => (a / w) * Math.sinh(w * t) + speed * Math.cosh(w * t);
  const fallen = (t: number): number => ((2 * a) / w ** 2) * Math.sinh((w * t) / 2) ** 2 + (speed / w) * Math.sinh(w * t);
  let [early, late] = [0, 100];
  for (let n = 0; n < 100; n++) {
    const t = (early + late) / 2;
    if (fast(t) < limit) early = t;
    else late = t;
  }
  if (a <= 0 || fallen(late) > distance) return null;
  const back = PULL - wind;
  return {
    time: late + (distance - fallen(late)) / limit + beyond,
    place: (limit / w) * Math.sinh(w * beyond) - ((2 * back) / w ** 2) * Math.sinh((w * beyond) / 2) ** 2,
    velocity: limit * Math.cosh(w * beyond) - (back / w) * Math.sinh(w * beyond),
  };
}

const even = (min: number, max: number) => fc.integer({ min: 0, max: 1e6 }).map((k) => min + ((max - min) * k) / 1e6);

describe('at the speed limit straight through the centre of the target', () => {
  it('the limit releases her in the centre, in a wind along her line, too', () => {
    let compared = 0;
    fc.assert(
      fc.property(
        fc.constantFrom(...DIRECTIONS),
        even(5, 200),
        even(300, 80_000),
        fc.oneof(fc.constant(0), even(0, 1)),
        even(10, 100),
        fc.oneof(fc.constant(0), even(-30, 30)),
        ([dx, dy], distance, range, share, axisLimit, wind) => {
          const long = Math.hypot(dx, dy);
          const fall = { distance, range, speed: share * axisLimit * long, limit: axisLimit * long, wind };
          // she has not turned back by then, and the pull still exceeds the wind
          const truth = fallThrough(fall, Math.min(0.2, (0.5 * fall.limit) / (PULL - wind)));
          if (truth === null) return;
          compared++;
          const along = (length: number) => ({ x: (length * dx) / long, y: (length * dy) / long });
          const velocity = along(fall.speed);
          const blows = along(wind);
          const level = {
            ...plainLevel({
              astronaut: { vx: velocity.x, vy: velocity.y },
              asteroids: [{ ...along(distance), radius: 1 }],
              range,
            }),
            winds: wind === 0 ? [] : [{ id: null, x: 0, y: 0, radius: 1e5, ax: blows.x, ay: blows.y }],
            rules: { speedLimit: axisLimit },
          };
          const ticks = Math.ceil(truth.time * 60) + 1;
          const { trajectory } = simulate(compile(level), [[0, ticks]], { maxTime: ticks / 60 });
          const out = new Float64Array(6);
          trajectory.at(truth.time, out);
          const end = along(distance + truth.place);
          const last = along(truth.velocity);
          expect(Math.hypot(out[0] - end.x, out[1] - end.y)).toBeLessThan(1e-9);
          expect(Math.hypot(out[2] - last.x, out[3] - last.y)).toBeLessThan(2e-9);
        },
      ),
      { numRuns: 200 },
    );
    expectDeep(compared).toBeGreaterThan(60);
  });
});

it('a start in the centre at the limit, in any wind, goes on as one beside it', () => {
  const speeds = fc.constantFrom(20, 50, 1000);
  const turn = fc.integer({ min: 0, max: 15 });
  fc.assert(
    fc.property(
      speeds,
      turn,
      fc.integer({ min: 1, max: 60 }),
      fc.constantFrom('fast', 'standard', 'precise'),
      (limit, k, wind, accuracy) => {
        const angle = (Math.PI * k) / 8;
        const endOf = (x: number) => {
          const level = {
            ...plainLevel({ astronaut: { x, vx: -limit }, asteroids: [{ x: 0, y: 0, radius: 5 }], range: 5000 }),
            winds: [{ id: null, x: 0, y: 0, radius: 4000, ax: wind * Math.cos(angle), ay: wind * Math.sin(angle) }],
            rules: { speedLimit: limit },
          };
          const budget = new WorkBudget(20_000);
          const { final, stopped } = simulate(compile(level, accuracy), [[0, 60]], { maxTime: 0.5, budget });
          expect(stopped).toBeNull();
          return final;
        };
        const [here, beside] = [endOf(0), endOf(-1e-9)];
        for (const key of ['x', 'y', 'vx', 'vy'] as const) expect(here[key]).toBeCloseTo(beside[key], 5);
      },
    ),
    { numRuns: 200 },
  );
});
