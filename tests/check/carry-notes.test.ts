import fc from 'fast-check';
import { expect, it } from 'vitest';
import { carryNotes, compareHolds, firstDifference } from '../../check/runs/index.ts';
import type { Hold } from '../../schema/index.ts';

const holds: fc.Arbitrary<Hold[]> = fc
  .array(fc.tuple(fc.integer({ min: 1, max: 90 }), fc.integer({ min: 1, max: 90 })), { maxLength: 7 })
  .map((gaps) => {
    let at = 0;
    return gaps.map(([wait, length]): Hold => {
      const press = at + wait;
      at = press + length;
      return [press, at];
    });
  });
const notes = fc.array(fc.record({ tick: fc.nat(900), text: fc.constantFrom('a', 'b') }), { maxLength: 6 });

const isHeld = (list: readonly Hold[], tick: number) => list.some(([press, release]) => press <= tick && tick < release);

it('keeps every note, and those at edges of holds that are kept', () => {
  fc.assert(
    fc.property(holds, holds, notes, (before, after, own) => {
      const edges = before.flat().map((tick) => ({ tick, text: 'edge' }));
      const carried = carryNotes([...own, ...edges], before, after);
      expect(carried.map(({ text }) => text).sort()).toEqual([...own, ...edges].map(({ text }) => text).sort());
      const { pairs } = compareHolds(before, after);
      const ticks = carried.filter(({ text }) => text === 'edge').map(({ tick }) => tick);
      for (const [, a] of pairs) expect(ticks).toEqual(expect.arrayContaining([...after[a]]));
      expect(carryNotes(own, before, before).map(({ tick }) => tick)).toEqual(own.map(({ tick }) => tick).sort((p, q) => p - q));
    }),
    { numRuns: 300 },
  );
});

it('pairs every hold at most once, in order of time, and counts all', () => {
  fc.assert(
    fc.property(holds, holds, (before, after) => {
      const { pairs, removed, added } = compareHolds(before, after);
      expect([...pairs.map(([b]) => b), ...removed].sort((p, q) => p - q)).toEqual([...before.keys()]);
      expect([...pairs.map(([, a]) => a), ...added].sort((p, q) => p - q)).toEqual([...after.keys()]);
      for (let i = 1; i < pairs.length; i++) {
        expect(pairs[i][0]).toBeGreaterThan(pairs[i - 1][0]);
        expect(pairs[i][1]).toBeGreaterThan(pairs[i - 1][1]);
      }
    }),
    { numRuns: 300 },
  );
});

it('finds the first tick at which two scripts differ', () => {
  fc.assert(
    fc.property(holds, holds, fc.boolean(), (before, other, isSame) => {
      const after = isSame ? before : other;
      const ticks = Array.from({ length: 1400 }, (_, tick) => tick);
      const first = ticks.find((tick) => isHeld(before, tick) !== isHeld(after, tick)) ?? Number.POSITIVE_INFINITY;
      expect(firstDifference(before, after)).toBe(first);
    }),
    { numRuns: 300 },
  );
});
