import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { continuousNames } from './accuracies.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

const TRIPLES = [
  [3, 4, 5],
  [4, 3, 5],
  [5, 12, 13],
  [8, 15, 17],
] as const;

const withWinds = (parts: PlainLevel, winds: readonly Omit<Level['winds'][number], 'id'>[]): Level => ({
  ...plainLevel(parts),
  winds: winds.map((wind) => ({ id: null, ...wind })),
});

describe.each(continuousNames)('she starts exactly on a rim, moves into it, and touches something: %s', (accuracy) => {
  const firstTouch = (level: Level) => {
    const { events } = simulate(compile(level, accuracy), [], { maxTime: 0.1 });
    return events.find(({ type }) => type === 'collided')?.time ?? null;
  };
  // along the right side of her box, which the circle touches
  const touching = { x: 26, y: 0, radius: 16 };
  const aliens = [touching];
  const novae = [touching];
  const asteroids = [{ x: 1e5, y: 1e5, radius: 16 }];
  const hot = [...asteroids, { ...touching, hot: true }];

  it('a wind acts from the very start: it may take her away, or into what she touches', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...TRIPLES),
        fc.integer({ min: 10, max: 60 }),
        fc.constantFrom(1, -1),
        fc.constantFrom(1, -1),
        fc.integer({ min: 9, max: 200 }),
        fc.integer({ min: 1, max: 80 }),
        ([a, b, c], size, side, way, strength, speed) => {
          const disc = { x: side * a * size, y: way * b * size, radius: c * size };
          const astronaut = { vy: way * speed };
          const blown = (parts: PlainLevel, ax: number) =>
            firstTouch(withWinds({ astronaut, ...parts }, [{ ...disc, ax, ay: 0 }]));
          expect(blown({ aliens }, -strength)).not.toBe(0);
          expect(blown({ aliens }, 0)).toBe(0);
          for (const parts of [{ novae }, { asteroids: hot }]) {
            expect(blown(parts, strength)).toBe(0);
            expect(blown(parts, -strength)).toBeNull();
            expect(blown(parts, 0)).toBeNull();
          }
        },
      ),
      { numRuns: 25 },
    );
  });

  it('so does a repulsor', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...TRIPLES),
        fc.constantFrom(1, -1),
        fc.integer({ min: 1, max: 20 }),
        ([a, b, c], way, speed) => {
          const push = 2 * 8 * (c / a);
          const pushed = (side: number, parts: PlainLevel) => {
            const repulsors = [{ x: side * a * 40, y: way * b * 40, radius: c * 40 }];
            return firstTouch({ ...plainLevel({ astronaut: { vy: way * speed }, repulsors, ...parts }), rules: { push } });
          };
          expect(pushed(1, { aliens })).not.toBe(0);
          expect(pushed(-1, { aliens })).toBe(0);
          for (const parts of [{ novae }, { asteroids: hot }]) {
            expect(pushed(1, parts)).toBeNull();
            expect(pushed(-1, parts)).toBe(0);
          }
        },
      ),
      { numRuns: 25 },
    );
  });

  it('her velocity within the limit says whether she moves into it', () => {
    // (30, -10) leads towards the centre, (10, -10) away from it
    const disc = { x: 30, y: 40, radius: 50, ax: -100, ay: 0 };
    const level = (speedLimit: number) => ({
      ...withWinds({ astronaut: { vx: 30, vy: -10 }, aliens }, [disc]),
      rules: { speedLimit },
    });
    const told = (speedLimit: number) =>
      simulate(compile(level(speedLimit), accuracy), [], { maxTime: 0 }).events.some(({ type }) => type === 'effect');
    expect([told(1000), told(10)]).toEqual([true, false]);
  });
});

it.each(continuousNames)('she starts on two rims, along one and into the other: %s', (accuracy) => {
  fc.assert(
    fc.property(
      fc.constantFrom(...TRIPLES),
      fc.integer({ min: 5, max: 40 }),
      fc.integer({ min: 1, max: 5 }),
      fc.boolean(),
      ([a, b, c], size, speed, first) => {
        const along = { x: -a * size, y: -b * size, radius: c * size, ax: 5, ay: -20 };
        // alone, the wind everywhere bends her path into the first disc; the wind that she enters bends it out of that
        const strength = (2 * c * speed * speed) / size;
        const everywhere = { x: 0, y: 0, radius: 1e4, ax: (-a / c) * strength, ay: (-b / c) * strength };
        const into = { x: 0, y: 600, radius: 600, ax: (3 * c * strength) / a, ay: 0 };
        const astronaut = { vx: -b * speed, vy: a * speed };
        const rims = first ? [along, into] : [into, along];
        const { final } = simulate(compile(withWinds({ astronaut }, [everywhere, ...rims]), accuracy), [], { maxTime: 0.1 });
        const x = astronaut.vx * 0.1 + (everywhere.ax + into.ax) * 0.005;
        const y = astronaut.vy * 0.1 + everywhere.ay * 0.005;
        expect(Math.hypot(final.x - x, final.y - y)).toBeLessThan(1e-9);
      },
    ),
    { numRuns: 25 },
  );
});
