import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, playScript, simulate } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { checkGraze, GRAZED_AT, graze } from '../judges/contacts.ts';
import { continuousNames } from './accuracies.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

describe('a minimal touch', () => {
  // bench/soak.ts tests any number of them
  it('is found, and a miss by as little is not: every kind, in every motion', () => {
    const counts = { hit: 0, missed: 0, vague: 0, bug: 0 };
    fc.assert(
      fc.property(fc.nat(2 ** 31 - 1), fc.constantFrom(...GRAZED_AT), (seed, accuracy) => {
        const made = graze(seed, accuracy);
        if (made === null) return;
        const finding = checkGraze(made);
        counts[finding.what]++;
        expect(finding).not.toHaveProperty('why');
      }),
      { numRuns: 300, endOnFailure: true },
    );
    expectDeep(counts.hit).toBeGreaterThan(36);
    expectDeep(counts.missed).toBeGreaterThan(36);
  });

  it('is found with a corner 0.001 px deep in a nova of 1e6 px', () => {
    const level = plainLevel({
      astronaut: { x: -9.238139180466533, vx: 3.1047603115439415, vy: 39.98261622386053 },
      range: 250,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      novae: [{ x: 178061.11388196418, y: -984044.9287186153, radius: 1e6 }],
    });
    const run = simulate(compile(level), [[0, 240]], { maxTime: 4 });
    expect(run.outcome).toBe('collided');
    expect(run.time).toBeCloseTo(2.83775372, 7);
  });
});

describe.each(continuousNames)('touching exactly is neither entering nor a contact: %s', (accuracy) => {
  const eventsOf = (parts: PlainLevel, holds: readonly Hold[], maxTime: number) =>
    simulate(compile(plainLevel(parts), accuracy), holds, { maxTime }).events.map(({ type }) => type);
  const TRIPLES = [
    [3, 4, 5],
    [5, 12, 13],
    [8, 15, 17],
    [20, 21, 29],
  ] as const;

  it('a rim that her line touches, whatever she passes before', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...TRIPLES),
        fc.integer({ min: 0, max: 12 }),
        fc.integer({ min: 2, max: 9 }),
        fc.constantFrom(1, -1),
        fc.boolean(),
        ([a, b, c], far, size, side, isPulled) => {
          // she moves along (a, b); the discs touch her line at `far` times that, from either side
          const disc = { x: a * far - side * b * size, y: b * far + side * a * size, radius: c * size };
          const tangent: PlainLevel = {
            astronaut: isPulled ? {} : { vx: a, vy: b },
            asteroids: [{ x: 40 * a, y: 40 * b, radius: 1 }],
            repulsors: [disc],
            winds: [{ ...disc, ax: 50 }],
            wormholes: [{ ...disc, toX: disc.x + 5000, toY: disc.y }],
            aliens: [{ x: disc.x + side * b * 1000, y: disc.y - side * a * 1000, radius: 5 }],
            // a line of minerals splits her way where nothing is exact
            minerals: Array.from({ length: 7 }, (_, i) => ({ x: a * i, y: b * i, radius: 0.37 })),
          };
          const events = eventsOf(tangent, isPulled ? [[0, 1200]] : [], isPulled ? 3 : 1.5 * far);
          expect(events.filter((type) => type === 'effect' || type === 'enter')).toEqual([]);
          if (far === 0) return;
          const deeper = { ...disc, radius: disc.radius + 1e-9 };
          expect(
            eventsOf({ ...tangent, repulsors: [deeper], winds: [], wormholes: [] }, isPulled ? [[0, 1200]] : [], 3 * far),
          ).toContain('enter');
        },
      ),
      { numRuns: 60 },
    );
  });

  it('a circle along which her box slides, when the speed limit sets in as well', () => {
    const falls = { asteroids: [{ x: 0, y: -50, radius: 20 }], blackHole: { x: -20, y: -2, radius: 10 } };
    const rules = { boxHeight: 20, speedLimit: 10 };
    expect(eventsOf({ ...falls, rules }, [[0, 30]], 0.5)).not.toContain('completed');
    expect(eventsOf({ ...falls, blackHole: { x: -20, y: -2, radius: 10 + 1e-9 }, rules }, [[0, 30]], 0.5)).toContain('completed');
  });

  it('two aliens that chase her side by side', () => {
    const aliens = [
      { x: -18, y: 0, radius: 5 },
      { x: -48, y: 0, radius: 25 },
    ];
    expect(eventsOf({ aliens }, [], 0.1)).not.toContain('explosion');
    expect(eventsOf({ aliens: [aliens[0], { ...aliens[1], radius: 25 + 1e-9 }] }, [], 0.1)).toContain('explosion');
  });
});

describe.each(continuousNames)('a rim that she crosses at the very start, however slowly: %s', (accuracy) => {
  const astronaut = { vy: -5 };
  const leaving: PlainLevel = { astronaut, range: 50, asteroids: [{ x: 50, y: 0, radius: 20 }] };

  it.each([[[]], [[[0, 30]]]] as Hold[][][])('the end of the range comes before a wormhole, with %j', (holds) => {
    const wormholes = [{ x: 8, y: -6, toX: 9, toY: -6, radius: 10 }];
    const run = simulate(compile(plainLevel({ ...leaving, wormholes }), accuracy), holds, { maxTime: 0.5 });
    expect(run.outcome).toBe('lost');
    expect(run.time).toBeLessThan(1e-15);
  });

  it('a second asteroid at the same range keeps her only if she comes nearer to it', () => {
    const outcome = (x: number) =>
      simulate(compile(plainLevel({ ...leaving, asteroids: [...leaving.asteroids!, { x, y: 30, radius: 5 }] }), accuracy), [])
        .outcome;
    expect(outcome(40)).toBe('lost');
    const nearer = { ...leaving, asteroids: [...leaving.asteroids!, { x: 40, y: -30, radius: 5 }] };
    expect(simulate(compile(plainLevel(nearer), accuracy), [], { maxTime: 0.5 }).outcome).toBe('timeout');
  });
});

describe('circling beside an object for a long time', () => {
  // on a circle of 100 px around an asteroid
  const circling = (parts: Parameters<typeof plainLevel>[0], d = 100) =>
    plainLevel({
      astronaut: { x: d, vy: Math.sqrt(39 * d * (1 - d / 250)) },
      range: 250,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      ...parts,
    });
  const cases = [
    ['a nova about the same centre', circling({ novae: [{ x: 0, y: 0, radius: 90 - 1e-9 }] })],
    ['a nova that she touches exactly', circling({ novae: [{ x: 0, y: 0, radius: 90 }] })],
    ['the rim of a wind that she follows exactly', circling({ winds: [{ x: 0, y: 0, radius: 100, ax: 9 }] })],
    ['a nova about nearly the same centre', circling({ novae: [{ x: 1e-8, y: 0, radius: 90 - 2e-8 }] })],
    ['a hot asteroid she circles', circling({ asteroids: [{ x: 0, y: 0, radius: 90 - 1e-9, hot: true }] })],
    ['the rim of a field', circling({ repulsors: [{ x: 0, y: 0, radius: 100 - 1e-9 }] })],
    ['the sight of an alien', circling({ aliens: [{ x: 0, y: 0, radius: 20 }] }, 150 + 1e-9)],
    ['the end of the range', circling({}, 250 - 1e-9)],
  ] as const;

  it.each(cases)('takes few evaluations: %s', (_, level) => {
    const simulation = createSimulation(compile(level));
    playScript(simulation, [[0, 1200]], 1200);
    const { work } = simulation as unknown as { work: { guards: number; pieces: number } };
    expect(simulation.ending).toBeNull();
    // every evaluation after the first ones counts as another guard
    expect(work.guards).toBeLessThan(8 * work.pieces);
    expect(work.pieces).toBeLessThan(40);
  });

  it('takes few evaluations at rest on the rim of a field, where she touches a nova exactly', () => {
    const level = plainLevel({
      asteroids: [{ x: 100, y: 0, radius: 5 }],
      repulsors: [{ x: 100, y: 0, radius: 100 }],
      novae: [{ x: -26, y: 22, radius: 20 }],
      rules: { boxHeight: 20 },
    });
    const simulation = createSimulation(compile(level));
    playScript(simulation, [[0, 60]], 60);
    expect(simulation.ending).toBeNull();
    expect((simulation as unknown as { work: { guards: number } }).work.guards).toBeLessThan(100);
  });
});
