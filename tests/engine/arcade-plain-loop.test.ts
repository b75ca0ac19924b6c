import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, DEFAULT_BOX, joinHolds, playScript, simulate } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { mixedScene } from '../scenes/mixed-scene.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { arbitraryLevel, arbitraryPlayableLevel } from './arbitrary-level.ts';
import { arbitraryRules } from './arbitrary-rules.ts';
import { plainFrames } from './arcade-plain-loop.ts';

// `arcade` skips objects that are too far to matter, frame by frame and cell by cell. This must not change a bit of the state,
// on any level, however it is advanced. A neighbourhood that misses one object would pass every test of the shipped levels.

const between = (min: number, max: number) => fc.integer({ min: 16 * min, max: 16 * max }).map((k) => k / 16);

/** Many objects around her, most of them near her path: she passes cells with all kinds of objects, grazes, and is chased. */
const crowdedLevel: fc.Arbitrary<Level> = fc
  .record({ playable: arbitraryPlayableLevel, recoil: fc.boolean(), small: fc.boolean(), range: between(150, 400) })
  .chain(({ playable, recoil, small, range }) => {
    const circle = (radius: number, apart: number) =>
      fc
        .tuple(between(-250, 250), between(-250, 250))
        .filter(([x, y]) => Math.max(Math.abs(x), Math.abs(y)) > apart)
        .map(([x, y]) => ({ id: null, x, y, radius }));
    const list = <T>(item: fc.Arbitrary<T>, maxLength: number) => fc.array(item, { maxLength });
    return fc
      .record({
        asteroids: fc.array(
          circle(small ? 0.25 : 16, 60).map((c) => ({ ...c, hot: (c.x + c.y) % 3 === 0 })),
          { minLength: 1, maxLength: 12 },
        ),
        novae: list(circle(16, 60), 6),
        repulsors: list(circle(48, 0), 3),
        aliens: list(circle(25, 80), 5),
        minerals: list(circle(7, 0), 6),
      })
      .map((things) => ({ ...playable, ...things, recoil, range }));
  });

const plan = fc.array(fc.record({ ticks: fc.integer({ min: 1, max: 150 }), held: fc.boolean() }), {
  minLength: 1,
  maxLength: 10,
});

function compareWithPlain(level: Level, steps: readonly { ticks: number; held: boolean }[]): void {
  const expected = plainFrames(
    level,
    steps.flatMap(({ ticks, held }) => Array.from({ length: ticks }, () => held)),
  );
  const simulation = createSimulation(compile(level, 'arcade'));
  for (const { ticks, held } of steps) simulation.advance(ticks, held);
  const state = new Float64Array(6);
  const aliens = new Float64Array(3 * level.aliens.length);
  const asteroids = new Float64Array(2 * level.asteroids.length);
  simulation.readState(state);
  simulation.readAliens(aliens);
  simulation.readAsteroids(asteroids);
  expect({
    frames: simulation.tick,
    outcome: simulation.ending?.outcome ?? null,
    minerals: simulation.mineralCount,
    collected: level.minerals.map((_, i) => simulation.isCollected(i)),
    state: [...state],
    aliens: [...aliens],
    asteroids: [...asteroids],
  }).toEqual(expected);
}

describe('arcade has the same bits as a loop that checks every object in every frame', () => {
  it.each([
    ['any', arbitraryLevel],
    ['playable', arbitraryPlayableLevel],
    ['crowded', crowdedLevel],
  ] as const)('on %s levels', (_, level) => {
    fc.assert(fc.property(level, plan, compareWithPlain), { numRuns: 60 });
  });

  it.each([
    ['any', arbitraryLevel],
    ['playable', arbitraryPlayableLevel],
    ['crowded', crowdedLevel],
  ] as const)('on %s levels with rules of their own', (_, level) => {
    const ruled = fc.record({ level, rules: arbitraryRules }).map((made) => ({ ...made.level, rules: made.rules }));
    fc.assert(fc.property(ruled, plan, compareWithPlain), { numRuns: 40 });
  });

  it('with every effect: a recorded run takes no frame for granted', () => {
    fc.assert(
      fc.property(fc.nat(2 ** 31 - 1), fc.constantFrom(mixedScene, windyScene, randomScene), (seed, of) => {
        const { level, holds, maxTime } = of(seed);
        const scene = compile(level, 'arcade');
        const { final, tick, minerals } = simulate(scene, holds, { maxTime });
        const simulation = createSimulation(scene);
        playScript(simulation, joinHolds(holds), Math.round(60 * maxTime));
        const state = new Float64Array(6);
        simulation.readState(state);
        expect([...state]).toEqual([final.x, final.y, final.vx, final.vy, final.cos, final.sin]);
        expect(simulation.ending?.tick ?? simulation.tick).toBe(tick);
        expect(simulation.mineralCount).toBe(minerals.length);
      }),
      { numRuns: 120 },
    );
  });

  it('if an alien that starts from rest is less than 2 px away', () => {
    // a corner of her box points at it: only there the box reaches as far as the preselected neighbours
    const corner = DEFAULT_BOX.halfDiagonal + 25;
    const gap = fc.integer({ min: 1, max: 200 }).map((k) => k / 100);
    const quarter = fc.tuple(fc.constantFrom(-1, 1), fc.constantFrom(-1, 1));
    fc.assert(
      fc.property(arbitraryPlayableLevel, gap, quarter, fc.integer({ min: 1, max: 60 }), (level, d, [sx, sy], ticks) => {
        const x = (sx * DEFAULT_BOX.halfWidth * (corner + d)) / DEFAULT_BOX.halfDiagonal;
        const y = (sy * DEFAULT_BOX.halfHeight * (corner + d)) / DEFAULT_BOX.halfDiagonal;
        const blackHole = { x: 200, y: 0, radius: 20 };
        const asteroids = [{ id: null, x: 100, y: -100, radius: 16, hot: false }];
        const still = { ...level, astronaut: { x: 0, y: 0, vx: 0, vy: 0 }, blackHole, asteroids, range: 400 };
        const alone = { ...still, novae: [], repulsors: [], minerals: [], aliens: [{ id: null, x, y, radius: 25 }] };
        compareWithPlain(alone, [
          { ticks, held: false },
          { ticks: 90, held: false },
        ]);
      }),
      { numRuns: 40 },
    );
  });

  it('if there are so many objects that an index finds the near ones', () => {
    const field = (count: number, radius: number, shift: number) =>
      Array.from({ length: count }, (_, i) => ({
        id: null,
        x: 90 * ((i % 20) - 10) + shift + (i % 7),
        y: 90 * (Math.floor(i / 20) - 5) + shift + (i % 5),
        radius,
      }));
    fc.assert(
      fc.property(arbitraryPlayableLevel, fc.boolean(), plan, (level, recoil, steps) => {
        const asteroids = field(200, 16, 45).map((a, i) => ({ ...a, hot: i % 9 === 0 }));
        compareWithPlain({ ...level, recoil, asteroids, novae: field(150, 7, 20), minerals: field(140, 7, 3) }, steps);
      }),
      { numRuns: 10 },
    );
  });

  it('if recoil drives an asteroid to the speed limit, from far away', () => {
    // light enough to reach it, and so far away that only the gun acts all the time
    const radius = between(5, 40).map((k) => k / 1e4);
    const nowhere = { x: 9000, y: 9000, radius: 18 };
    fc.assert(
      fc.property(arbitraryPlayableLevel, between(400, 1500), between(-400, 400), radius, plan, (level, x, y, r, steps) => {
        const asteroids = [{ id: null, x, y, radius: r, hot: false }];
        const alone = { ...level, asteroids, novae: [], repulsors: [], aliens: [], minerals: [], blackHole: nowhere };
        compareWithPlain({ ...alone, recoil: true, range: 4000 }, [{ ticks: 100, held: true }, ...steps]);
      }),
      { numRuns: 40 },
    );
  });

  it('if a hot asteroid comes to her slowly, from beyond a neighbourhood', () => {
    // at the end of the range the pull is nearly 0, but recoil has its full strength: the asteroid comes to her, and she waits
    // at the nearest side of her cell
    const scene = fc.record({
      x: between(0, 4),
      y: between(10, 22),
      away: between(40, 90),
      left: between(0, 1),
      radius: between(1, 3).map((r) => r / 4),
      vx: between(-1, 1),
    });
    const steps = fc.tuple(fc.integer({ min: 30, max: 240 }), fc.integer({ min: 300, max: 2000 }));
    fc.assert(
      fc.property(arbitraryPlayableLevel, scene, steps, (level, { x, y, away, left, radius, vx }, [held, waited]) => {
        const asteroids = [{ id: null, x: x - away, y, radius, hot: true }];
        const alone = { ...level, asteroids, novae: [], repulsors: [], aliens: [], minerals: [] };
        compareWithPlain({ ...alone, astronaut: { x, y, vx, vy: 0 }, recoil: true, range: away + left }, [
          { ticks: held, held: true },
          { ticks: waited, held: false },
        ]);
      }),
      { numRuns: 60 },
    );
  });
});
