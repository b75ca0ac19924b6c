import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { cleanRun, createSearch, type Goal } from '../../solver/index.ts';
import { expectDeep } from '../depth.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { arbitraryOrdinaryLevel, arbitrarySolvableLevel, fallThrough } from './search/solvable-levels.ts';

describe.each(accuracyNames)('simplifying at %s', (accuracy) => {
  it('returns a run that simulate confirms and that has no more presses, ends no later and meets the goal', () => {
    let cleaned = 0;
    fc.assert(
      fc.property(
        fc.oneof(arbitrarySolvableLevel, arbitraryOrdinaryLevel),
        fc.constantFrom('any', 'all'),
        fc.nat(),
        (level, minerals, seed) => {
          const goal: Goal = { minerals: minerals === 'all' ? 'all' : 'any' };
          const scene = compile(level, accuracy);
          const search = createSearch(scene, { goal, seed });
          search.advance(6000);
          const [found] = search.solutions;
          if (found === undefined) return;
          cleaned++;
          const clean = cleanRun(scene, found.holds, goal, { maxRuns: 120 });
          expect(clean).not.toBeNull();
          if (clean === null) return;
          expect(clean.run.holds.length).toBeLessThanOrEqual(found.holds.length);
          expect(clean.run.tick).toBeLessThanOrEqual(found.tick);
          expect(clean.effort.runs).toBeLessThanOrEqual(120);
          const run = simulate(scene, clean.run.holds);
          expect(run.outcome).toBe('completed');
          expect({ tick: run.tick, time: run.time }).toEqual({ tick: clean.run.tick, time: clean.run.time });
          if (goal.minerals === 'all') expect(clean.run.minerals.length).toBe(level.minerals.length);
        },
      ),
      { numRuns: 8 },
    );
    expectDeep(cleaned).toBeGreaterThan(2);
  });

  it('drops needless presses and idle waiting', () => {
    const scene = compile(fallThrough(), accuracy);
    const search = createSearch(scene, { seed: 1 });
    while (search.solutions.length === 0) search.advance(1000);
    const { holds } = search.solutions[0];
    expect(holds.length).toBe(1);
    // She waits two seconds at first, and releases for a moment on the way.
    const [[press, release]] = holds;
    const clumsy = [
      [press + 120, release + 100],
      [release + 101, release + 120],
    ] as const;
    const clean = cleanRun(scene, clumsy, { minerals: 'any' });
    expect(clean?.run.holds.length).toBe(1);
    expect(clean?.run.holds[0][0]).toBe(0);
    const before = simulate(scene, clumsy);
    expect(before.outcome).toBe('completed');
    expect(clean?.run.tick).toBeLessThanOrEqual(before.tick - 90);
  });
});

it('returns null when the run does not meet the goal', () => {
  const scene = compile(fallThrough(), 'precise');
  expect(cleanRun(scene, [], { minerals: 'any' })).toBeNull();
});
