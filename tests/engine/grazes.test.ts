import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, playScript, simulate } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { checkGraze, GRAZED_AT, graze } from '../judges/contacts.ts';
import { plainLevel } from './plain-level.ts';

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
});
