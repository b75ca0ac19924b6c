import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, type Scene, simulate } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { findShortcuts, verifyRun } from '../../solver/index.ts';
import { expectDeep } from '../depth.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { shippedLevel } from './shipped-level.ts';

const ANY = { minerals: 'any' } as const;
const MAX_TICKS = 900;

/** Replays each pair at multiples of the stride: slow and simple. */
function bruteForce(scene: Scene, goal: Parameters<typeof verifyRun>[2], length: number, stride: number): number {
  let count = 0;
  for (let press = 0; press < length; press += stride) {
    for (let release = press + stride; release <= length; release += stride) {
      if (verifyRun(scene, [[press, release]], goal, MAX_TICKS) !== null) count++;
    }
  }
  return count;
}

const near = fc.integer({ min: -150, max: 150 });

/**
 * A level that a single press often completes: she is moving, the black hole is near, and something may turn her on the way.
 */
const nearLevel: fc.Arbitrary<Level> = fc
  .record({
    vx: fc.integer({ min: -60, max: 60 }),
    vy: fc.integer({ min: -60, max: 60 }),
    hole: fc.tuple(fc.integer({ min: -150, max: 150 }), fc.integer({ min: -150, max: 150 })),
    rocks: fc.array(fc.tuple(fc.integer({ min: -160, max: 160 }), fc.integer({ min: -160, max: 160 })), {
      minLength: 1,
      maxLength: 3,
    }),
    field: fc.option(fc.tuple(fc.integer({ min: -150, max: 150 }), fc.integer({ min: -150, max: 150 }))),
    nova: fc.option(fc.tuple(fc.integer({ min: 40, max: 150 }), fc.integer({ min: 40, max: 150 }))),
    recoil: fc.boolean(),
    wind: fc.option(fc.tuple(near, near, fc.integer({ min: -60, max: 60 }))),
    mouths: fc.option(fc.tuple(near, near, near, near)),
  })
  .map(({ vx, vy, hole, rocks, field, nova, recoil, wind, mouths }) => ({
    ...plainLevel({
      astronaut: { vx, vy },
      blackHole: { x: hole[0], y: hole[1], radius: 40 },
      range: 300,
      recoil,
      asteroids: rocks.map(([x, y]) => ({ x, y, radius: 16 })),
      repulsors: field === null ? [] : [{ x: field[0], y: field[1], radius: 48 }],
      novae: nova === null ? [] : [{ x: nova[0], y: nova[1], radius: 16 }],
      minerals: [{ x: hole[0] - 40, y: hole[1], radius: 30 }],
    }),
    winds: wind === null ? [] : [{ id: null, x: wind[0], y: wind[1], radius: 60, ax: wind[2], ay: 20 }],
    wormholes: mouths === null ? [] : [{ id: null, x: mouths[0], y: mouths[1], toX: mouths[2], toY: mouths[3], radius: 40 }],
  }));

describe('single presses', () => {
  const stride = fc.constantFrom(1, 1, 2, 5);
  for (const accuracy of ['arcade', 'precise'] satisfies AccuracyName[]) {
    it(`are counted exactly as by replaying every pair, at ${accuracy}`, () => {
      let winning = 0;
      fc.assert(
        fc.property(
          nearLevel,
          fc.integer({ min: 1, max: 30 }),
          stride,
          fc.constantFrom('any', 'all'),
          (level, length, stride, minerals) => {
            const scene = compile(level, accuracy);
            const goal = { minerals } as const;
            const { onePress } = findShortcuts(scene, goal, { length, stride, effort: 0, maxTicks: MAX_TICKS });
            const steps = Math.floor(length / stride);
            expect(onePress).toMatchObject({ tried: (steps * (steps + 1)) / 2, stride });
            expect(onePress.count).toBe(bruteForce(scene, goal, length, stride));
            expect(onePress.example === null).toBe(onePress.count === 0);
            if (onePress.count > 0) winning++;
          },
        ),
        { numRuns: 30 },
      );
      // Otherwise the levels above would test nothing.
      expectDeep(winning).toBeGreaterThan(5);
    });
  }

  it('have an example that wins', () => {
    const scene = compile(shippedLevel('02-first-swing'));
    const { onePress, withoutPressing } = findShortcuts(scene, ANY, {
      run: shippedLevel('02-first-swing').runs[0].holds,
      effort: 0,
    });
    expect(withoutPressing).toBeNull();
    expect(onePress.count).toBeGreaterThan(0);
    expect(onePress.example?.holds).toHaveLength(1);
    expect(simulate(scene, onePress.example!.holds).outcome).toBe('completed');
  });
});

describe('without pressing', () => {
  const drifting = (y: number) =>
    plainLevel({ astronaut: { vx: 50 }, blackHole: { x: 200, y }, asteroids: [{ x: 100, y: 200, radius: 16 }] });

  it('is found where she drifts into the black hole', () => {
    const { withoutPressing, onePress } = findShortcuts(compile(drifting(0)), ANY, { length: 30, effort: 0 });
    expect(withoutPressing?.holds).toEqual([]);
    expect(onePress.count).toBeGreaterThan(0);
  });

  it('is not found where she passes the black hole', () => {
    expect(findShortcuts(compile(drifting(60)), ANY, { length: 1, effort: 0 }).withoutPressing).toBeNull();
  });
});

describe('without an asteroid', () => {
  const use = (level: Level) => {
    const scene = compile(level);
    const run = level.runs[0].holds;
    return { scene, found: findShortcuts(scene, ANY, { run, length: 1, effort: 200_000 }).withoutAsteroid };
  };

  it('asks about the asteroids that the run targets, and no others', () => {
    const level = shippedLevel('09-bumper-alley');
    const { scene, found } = use(level);
    const targets = simulate(scene, level.runs[0].holds).events.flatMap((e) => (e.type === 'target' ? [e.index] : []));
    expect(found.map(({ asteroid }) => asteroid)).toEqual([...new Set(targets)].sort((a, b) => a - b));
  });

  it('returns a run that does not target an avoidable asteroid', () => {
    const { scene, found } = use(shippedLevel('09-bumper-alley'));
    const avoidable = found.filter((f) => f.use === 'avoidable');
    expect(avoidable).not.toHaveLength(0);
    for (const { asteroid, run } of avoidable) {
      const { outcome, events } = simulate(scene, run!.holds);
      expect(outcome).toBe('completed');
      expect(events.some((e) => e.type === 'target' && e.index === asteroid)).toBe(false);
    }
  });

  it('says needed only with a proof that nothing else is in range', () => {
    const { found } = use(shippedLevel('01-first-pull'));
    expect(found).toEqual([{ asteroid: 0, use: 'needed', run: null }]);
  });
});
