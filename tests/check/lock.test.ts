import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ticksToAgree } from '../../check/index.ts';
import { entryChange, isAgreed, resultChange } from '../../check/lock/index.ts';
import { ACCURACIES, compile, DEFAULT_TERMS } from '../../engine/index.ts';
import { type Hold, type LockEntry, resolveLevel } from '../../schema/index.ts';
import { certify } from '../../solver/index.ts';
import { describeDeep } from '../depth.ts';

const GOOD: LockEntry = {
  verdict: 'completable',
  accuracy: 'precise',
  outcome: 'completed',
  tick: 398,
  minerals: 3,
  mineralCount: 3,
  certifiedTicks: 3,
  hash: 'aa',
};
const NO_RUN: LockEntry = { verdict: 'unproven', accuracy: 'precise' };

describe('the difference between two results', () => {
  it.each<[Partial<LockEntry>, string]>([
    [{ tick: 412, minerals: 2, hash: 'bb' }, 'completed at tick 412, before 398; 2 of 3 minerals, before 3'],
    [
      { verdict: 'broken', outcome: 'collided', tick: 12, minerals: 0, certifiedTicks: undefined, hash: 'bb' },
      'broken, before completable; collided at tick 12, before completed at tick 398; 0 of 3 minerals, before 3; certified ticks none, before 3',
    ],
    [{ mineralCount: 4 }, '3 of 4 minerals, before 3 of 3 minerals'],
    [{ certifiedTicks: 1, hash: 'bb' }, 'certified ticks 1, before 3'],
    [{ hash: 'bb' }, 'the same end by another motion: hash bb, before aa'],
  ])('%j is said as %s', (change, words) => {
    expect(resultChange({ ...GOOD, ...change }, GOOD)).toEqual({ words, rules: '' });
  });

  it('is said for a level that has lost its run, or got its first', () => {
    expect(resultChange(NO_RUN, GOOD)?.words).toBe(
      'unproven, before completable; no run was played, before completed at tick 398; certified ticks none, before 3',
    );
    expect(resultChange(GOOD, NO_RUN)?.words).toBe(
      'completable, before unproven; completed at tick 398, before no run was played; certified ticks 3, before none',
    );
  });

  it('names the rules that differ, and other rules alone are none', () => {
    const before = { ...GOOD, rules: { pull: 42 } };
    expect(resultChange({ ...GOOD, tick: 400 }, before)).toEqual({
      words: 'completed at tick 400, before 398',
      rules: 'pull 39, before 42',
    });
    expect(resultChange(GOOD, before)).toBeNull();
    expect(isAgreed(GOOD, before)).toBe(false);
    expect(entryChange(GOOD, before)).toBe('rules: pull 39, before 42');
    expect(entryChange({ ...GOOD, accuracy: 'fast' }, GOOD)).toBe('accuracy fast, before precise');
  });

  it('is there exactly when something that the game shows differs', () => {
    const small = fc.integer({ min: 0, max: 2 });
    const entry: fc.Arbitrary<LockEntry> = fc.record({
      verdict: fc.constantFrom('completable', 'broken'),
      accuracy: fc.constant('precise'),
      outcome: fc.constantFrom('completed', 'lost'),
      tick: small,
      minerals: small,
      mineralCount: small,
      certifiedTicks: fc.option(small, { nil: undefined }),
      hash: fc.constantFrom('aa', 'bb'),
    });
    fc.assert(
      fc.property(entry, entry, (a, b) => {
        const change = resultChange(a, b);
        expect(change === null).toBe(isAgreed(a, b));
        if (change === null) return;
        expect(change.words).not.toMatch(/undefined|null|^$/);
        // it names both sides
        expect(change.words).toContain(', before ');
        expect(entryChange(a, b)).toBe(change.words);
      }),
    );
  });
});

describeDeep('certified ticks for a lock', () => {
  const level = resolveLevel({
    version: 1,
    name: 'Straight through',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 170, y: 0 },
    asteroids: [{ x: 100, y: 0, radius: 16 }],
  });
  const scene = compile(level, ACCURACIES.precise);

  it('are those that certify finds, up to 10, or a lower bound where there are too many combinations', () => {
    const of = (holds: readonly Hold[]) => ({
      most: certify(scene, holds, { minerals: 'any' }, { limit: 10 }).ticks,
      agreed: ticksToAgree(scene, holds),
    });
    for (const holds of [[[0, 600]], [[3, 100]], [[0, 70]]] as Hold[][]) expect(of(holds).agreed).toBe(of(holds).most);
    const { most, agreed } = of([
      [0, 30],
      [60, 100],
    ]);
    expect(agreed).toBeGreaterThan(0);
    expect(agreed).toBeLessThan(most);
  });

  it('are none when the work does not suffice, and the same for all limits that suffice', () => {
    const under = (maxWork: number) => compile(level, { ...DEFAULT_TERMS, maxWork });
    const found = [2, 6, 200, 6000, 200_000, 400_000].map((work) => ticksToAgree(under(work), [[3, 100]]));
    expect(found[0]).toBeNull();
    const measured = found.filter((ticks) => ticks !== null);
    expect(measured.length).toBeGreaterThan(1);
    expect(new Set(measured).size).toBe(1);
  });
});
