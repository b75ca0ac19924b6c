import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { joinHolds } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { arbitraryHolds } from './arbitrary-level.ts';

const heldTicks = (holds: readonly Hold[]) => {
  const ticks = new Set<number>();
  for (const [press, release] of holds) for (let tick = press; tick < release; tick++) ticks.add(tick);
  return [...ticks].sort((a, b) => a - b);
};

describe('joining holds', () => {
  it('holds exactly the ticks that any of them holds', () => {
    fc.assert(
      fc.property(arbitraryHolds(60), (holds) => {
        expect(heldTicks(joinHolds(holds))).toEqual(heldTicks(holds));
      }),
    );
  });

  it('gives holds in order, none of which is empty or touches the next', () => {
    fc.assert(
      fc.property(arbitraryHolds(60), (holds) => {
        const joined = joinHolds(holds);
        for (const [press, release] of joined) expect(press).toBeLessThan(release);
        for (let i = 1; i < joined.length; i++) expect(joined[i - 1][1]).toBeLessThan(joined[i][0]);
      }),
    );
  });

  it('depends on neither order nor repetition, and joining again changes nothing', () => {
    fc.assert(
      fc.property(arbitraryHolds(60), (holds) => {
        const joined = joinHolds(holds);
        expect(joinHolds([...holds].reverse())).toEqual(joined);
        expect(joinHolds([...holds, ...holds])).toEqual(joined);
        expect(joinHolds(joined)).toEqual(joined);
      }),
    );
  });

  it('does not change its arguments', () => {
    const holds: Hold[] = [
      [5, 9],
      [0, 6],
    ];
    const copy = structuredClone(holds);
    joinHolds(holds);
    expect(holds).toEqual(copy);
  });
});
