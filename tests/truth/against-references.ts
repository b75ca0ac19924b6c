import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, type Run, simulate } from '../../engine/index.ts';
import { differences, distanceAtEnd, sameEnding } from './compare-run.ts';
import type { ReferenceCase } from './references.ts';

/** What each accuracy but `precise` promises over many runs: px at the 90th percentile, share of endings that are right. */
const PROMISES: readonly { accuracy: AccuracyName; px: number; endings: number }[] = [
  { accuracy: 'standard', px: 1e-3, endings: 1 },
  { accuracy: 'fast', px: 0.5, endings: 0.98 },
];

const played = new Map<AccuracyName, WeakMap<ReferenceCase, Run>>();

/** Plays a case at an accuracy; it does so once. */
function play(c: ReferenceCase, accuracy: AccuracyName): Run {
  const runs = played.get(accuracy) ?? new WeakMap<ReferenceCase, Run>();
  played.set(accuracy, runs);
  const run = runs.get(c) ?? simulate(compile(c.level, accuracy), c.reference.holds, { maxTime: 60 });
  runs.set(c, run);
  return run;
}

/**
 * Declares the comparison of every accuracy with the references.
 * @param among all that shares are counted in, where `cases` alone are few and chosen to be hard
 */
export function compareWithReferences(title: string, cases: readonly ReferenceCase[], among = cases): void {
  const well = cases.filter((c) => !c.ill);
  const counted = among.filter((c) => !c.ill);

  describe(`${title}: precise`, () => {
    it('there are references to compare with', () => expect(well.length).toBeGreaterThan(0));

    it.each(well)('$id: $why', (c) => {
      expect(differences(play(c, 'precise'), c.reference)).toEqual([]);
    });

    // what ends on the last bit of the start can't be asserted; a person should see it, though
    it('says where ill-conditioned runs end otherwise', () => {
      const other = cases.filter((c) => c.ill && !sameEnding(play(c, 'precise'), c.reference));
      if (other.length > 0) console.info(`ill-conditioned, ending otherwise: ${other.map((c) => c.id).join('; ')}`);
    });
  });

  describe.each(PROMISES)(`${title}: $accuracy`, ({ accuracy, px, endings }) => {
    it(`ends as the references do, ${100 * endings} % of the runs`, () => {
      const wrong = counted.filter((c) => !sameEnding(play(c, accuracy), c.reference));
      const told = (c: ReferenceCase) => `${c.id}: ${play(c, accuracy).outcome} ${play(c, accuracy).with?.kind ?? ''}`;
      const most = Math.floor((1 - endings) * counted.length);
      expect(wrong.length > most ? wrong.map(told) : []).toEqual([]);
    });

    it(`ends within ${px} px of the references on 90 % of the runs`, () => {
      const errors = counted.map((c) => distanceAtEnd(play(c, accuracy), c.reference)).sort((a, b) => a - b);
      expect(errors[Math.ceil(0.9 * errors.length) - 1]).toBeLessThanOrEqual(px);
    });
  });
}
