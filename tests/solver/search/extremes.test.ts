import { describe, expect, it } from 'vitest';
import { compile } from '../../../engine/index.ts';
import { createSearch } from '../../../solver/index.ts';
import { accuracyNames } from '../../engine/accuracies.ts';
import { plainLevel } from '../../engine/plain-level.ts';
import { fallThrough } from './solvable-levels.ts';

/** So many of a kind on a grid, away from the start. */
const many = (count: number, radius: number) =>
  Array.from({ length: count }, (_, i) => ({ x: 300 + 60 * (i % 100), y: 60 * Math.floor(i / 100) - 2000, radius }));

describe.each(accuracyNames)('at %s', (accuracy) => {
  const solve = (level: ReturnType<typeof plainLevel>, options: Parameters<typeof createSearch>[1] = {}, ticks = 3000) => {
    const search = createSearch(compile(level, accuracy), options);
    search.advance(ticks);
    return search;
  };

  it('without asteroids she is lost, and the search ends', () => {
    const search = solve({ ...plainLevel({ range: 250 }), asteroids: [] });
    expect(search.solutions).toEqual([]);
    expect(search.effort.ticks).toBeGreaterThan(0);
  });

  it('if she starts beyond the range, the search ends', () => {
    expect(solve(plainLevel({ range: 250 })).solutions).toEqual([]);
  });

  it('if she starts in the black hole, no press is needed', () => {
    const search = solve({ ...fallThrough(), blackHole: { x: 5, y: 5, radius: 18 } });
    expect(search.solutions[0]).toMatchObject({ holds: [], tick: 0 });
  });

  it('if she starts in a nova, nothing is found', () => {
    expect(solve({ ...fallThrough(), novae: [{ id: null, x: 0, y: 0, radius: 16 }] }).solutions).toEqual([]);
  });

  it('if the goal requires more minerals than there are, nothing is simulated', () => {
    const search = solve(fallThrough(), { goal: { minerals: 3 } });
    expect(search.exhausted).toBe(true);
    expect(search.effort).toEqual({ runs: 0, ticks: 0 });
    expect(search.closest).toBeNull();
  });

  it('without novae or anything to find, it goes on and stays in bounds', () => {
    const search = solve(plainLevel({ range: 1e6 }), { maxTicks: 100 }, 20_000);
    expect(search.solutions).toEqual([]);
    expect(search.effort.ticks).toBeGreaterThanOrEqual(20_000);
  });

  it.each(['novae', 'minerals', 'asteroids'] as const)('10,000 %s', (kind) => {
    const objects = many(10_000, 7).map((o) => ({ id: null, hot: false, ...o }));
    const level = { ...fallThrough(), recoil: true };
    const search = solve({ ...level, [kind]: [...level[kind], ...objects] }, { seed: 1 }, 2500);
    expect(search.effort.ticks).toBeGreaterThanOrEqual(2500);
    if (kind !== 'asteroids') expect(search.solutions.length).toBeGreaterThan(0);
  });

  it('finds the drift into the black hole', () => {
    const level = fallThrough();
    const search = solve({ ...level, astronaut: { x: 0, y: 0, vx: 0, vy: -60 }, blackHole: { x: 5, y: -150, radius: 18 } });
    expect(search.solutions.some(({ holds }) => holds.length === 0)).toBe(true);
  });
});
