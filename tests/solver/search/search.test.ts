import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate, TICK_RATE } from '../../../engine/index.ts';
import { type Candidate, createSearch, type Goal, mineralsNeeded, type Search, verifyRun } from '../../../solver/index.ts';
import { expectDeep } from '../../depth.ts';
import { accuracyNames } from '../../engine/accuracies.ts';
import { arbitraryPlayableLevel } from '../../engine/arbitrary-level.ts';
import { arbitraryOrdinaryLevel, arbitrarySolvableLevel, fallThrough, swing } from './solvable-levels.ts';

const goal: fc.Arbitrary<Goal> = fc.record({ minerals: fc.constantFrom('any' as const, 'all' as const, 1, 2) });

/** Everything observable about a search. */
const view = (search: Search) => ({
  solutions: search.solutions,
  effort: search.effort,
  closest: search.closest,
  explored: search.explored,
});

/** What `simulate` says of a candidate, in the form of a candidate. */
function played(search: Search, { holds }: Candidate, maxTicks: number) {
  const run = simulate(search.scene, holds, { maxTime: maxTicks / TICK_RATE });
  const minerals = [...new Set(run.minerals.map(({ index }) => index))].sort((a, b) => a - b);
  return { outcome: run.outcome, candidate: { holds, tick: run.tick, time: run.time, minerals }, hash: run.hash };
}

describe.each(accuracyNames)('a search at %s', (accuracy) => {
  it('finds only runs that simulate confirms bit for bit, within the time, with the minerals', () => {
    let found = 0;
    fc.assert(
      fc.property(
        fc.oneof(arbitrarySolvableLevel, arbitraryOrdinaryLevel, arbitraryPlayableLevel),
        goal,
        fc.nat(),
        (level, wanted, seed) => {
          const maxTicks = 1200;
          const search = createSearch(compile(level, accuracy), { goal: wanted, seed, maxTicks });
          search.advance(8000);
          found += search.solutions.length;
          for (const candidate of search.solutions) {
            const { outcome, candidate: replayed, hash } = played(search, candidate, maxTicks);
            expect(outcome).toBe('completed');
            expect(candidate).toEqual(replayed);
            expect(candidate.tick).toBeLessThan(maxTicks);
            expect(candidate.minerals.length).toBeGreaterThanOrEqual(mineralsNeeded(wanted, level.minerals.length));
            expect(
              candidate.holds.every(([press, release], i) => press < release && press >= (candidate.holds[i - 1]?.[1] ?? 0)),
            ).toBe(true);
            // The same run once more, on a scene of its own.
            expect(simulate(compile(level, accuracy), candidate.holds, { maxTime: maxTicks / TICK_RATE }).hash).toBe(hash);
          }
        },
      ),
      { numRuns: 10 },
    );
    expectDeep(found).toBeGreaterThan(3);
  });

  it('gives the same result however it is advanced, and for the same seed', () => {
    fc.assert(
      fc.property(
        arbitraryOrdinaryLevel,
        goal,
        fc.nat(),
        fc.array(fc.integer({ min: 1, max: 3000 }), { maxLength: 8 }),
        (level, wanted, seed, parts) => {
          const scene = compile(level, accuracy);
          const total = parts.reduce((sum, ticks) => sum + ticks, 0);
          const whole = createSearch(scene, { goal: wanted, seed });
          const count = whole.advance(total);
          const split = createSearch(scene, { goal: wanted, seed });
          const counts = parts.map((ticks) => split.advance(ticks));
          expect(view(split)).toEqual(view(whole));
          expect(counts.reduce((sum, n) => sum + n, 0)).toBe(count);
          expect(whole.solutions.length).toBe(count);
        },
      ),
      { numRuns: 8 },
    );
  });

  it('solves a fall, a swing, and both with all minerals', () => {
    for (const level of [fallThrough(), swing()]) {
      for (const minerals of ['any', 'all'] as const) {
        const search = createSearch(compile(level, accuracy), { goal: { minerals }, seed: 1 });
        for (let i = 0; i < 60 && search.solutions.length === 0; i++) search.advance(10_000);
        expect(search.solutions.length, `${minerals} in ${search.effort.ticks} ticks`).toBeGreaterThan(0);
        if (minerals === 'all') expect(search.solutions[0].minerals.length).toBe(level.minerals.length);
      }
    }
  });

  it('goes on after the first run and finds others', () => {
    const search = createSearch(compile(swing(), accuracy), { seed: 2 });
    search.advance(100_000);
    const scripts = new Set(search.solutions.map(({ holds }) => JSON.stringify(holds)));
    expect(scripts.size).toBe(search.solutions.length);
    expect(scripts.size).toBeGreaterThan(5);
    expect(new Set(search.solutions.map(({ holds }) => holds.length)).size).toBeGreaterThan(1);
  });

  it('reports the closest approach, with a run that comes so near', () => {
    // The black hole is behind a wall of novae: it can be approached, but not reached.
    const wall = [-60, -30, 0, 30, 60].map((y) => ({ x: 190, y, radius: 16 }));
    const level = { ...fallThrough(), novae: wall.map((o) => ({ id: null, ...o })) };
    const search = createSearch(compile(level, accuracy), { seed: 3 });
    search.advance(5000);
    const { closest } = search;
    expect(closest).not.toBeNull();
    const run = simulate(search.scene, closest?.holds ?? [], { maxTime: (closest?.tick ?? 0) / TICK_RATE });
    const hole = level.blackHole;
    const apart = Math.hypot(run.final.x - hole.x, run.final.y - hole.y) - hole.radius;
    expect(Math.abs(apart - (closest?.distance ?? 0))).toBeLessThan(20);
  });
});

describe('other seeds', () => {
  it('search differently', () => {
    const scene = compile(swing(), 'arcade');
    const efforts = [1, 2, 3, 4].map((seed) => {
      const search = createSearch(scene, { seed });
      search.advance(30_000);
      return JSON.stringify(search.explored);
    });
    expect(new Set(efforts).size).toBe(4);
  });
});

describe('the judge', () => {
  it('refuses a run that is too late or has too few minerals, and cuts what comes after the end', () => {
    const scene = compile(fallThrough(), 'precise');
    const search = createSearch(scene, { seed: 1 });
    while (search.solutions.length === 0) search.advance(1000);
    const [found] = search.solutions;
    const { holds, tick } = found;
    expect(verifyRun(scene, holds, { minerals: 'any' }, tick + 1)).toEqual(found);
    expect(verifyRun(scene, holds, { minerals: 'any' }, tick)).toBeNull();
    expect(verifyRun(scene, holds, { minerals: 3 })).toBeNull();
    expect(verifyRun(scene, [...holds, [tick + 5, tick + 90]])).toEqual(found);
    expect(verifyRun(scene, [])).toBeNull();
  });
});
