import fc from 'fast-check';
import { expect, it } from 'vitest';
import { type Motion, PackedPieces, SLOTS } from '../../engine/motion/index.ts';
import { HEAD } from '../../engine/motion/state.ts';

const { DEGREE, MOVES } = SLOTS;
const MOST = 24;

/** The part of a motion that a piece is made of. */
function motion() {
  const s = new Float64Array(HEAD);
  const [ux, uy, px, py] = Array.from({ length: 4 }, () => new Float64Array(MOST + 1));
  return {
    ...{ s, ux, uy, px, py },
    get recoil() {
      return s[MOVES] === 1;
    },
  };
}

const piece = fc.record({ degree: fc.integer({ min: 0, max: MOST }), moves: fc.boolean() });

// enough pieces for several blocks, which some of them fill to the last number
it('every recorded piece is restored as it was, in any order', () => {
  fc.assert(
    fc.property(fc.array(piece, { minLength: 1, maxLength: 200, size: 'max' }), fc.infiniteStream(fc.nat()), (pieces, picks) => {
      const from = motion();
      const packed = new PackedPieces();
      let next = 0;
      const kept = pieces.map(({ degree, moves }) => {
        for (const numbers of [from.s, from.ux, from.uy, from.px, from.py]) for (const k of numbers.keys()) numbers[k] = next++;
        from.s[DEGREE] = degree;
        from.s[MOVES] = moves ? 1 : 0;
        expect(packed.add(from as unknown as Motion)).toBe(HEAD + (moves ? 4 : 2) * (degree + 1));
        const series = moves ? [from.ux, from.uy, from.px, from.py] : [from.ux, from.uy];
        return { s: [...from.s], series: series.map((c) => [...c.subarray(0, degree + 1)]) };
      });
      for (let n = 0; n < 2 * kept.length; n++) {
        const i = (picks.next().value ?? 0) % kept.length;
        const into = motion();
        packed.restore(i, into as unknown as Motion);
        const { s, series } = kept[i];
        expect([...into.s]).toEqual(s);
        for (const [k, c] of [into.ux, into.uy, into.px, into.py].slice(0, series.length).entries())
          expect([...c.subarray(0, series[k].length)]).toEqual(series[k]);
      }
    }),
    { numRuns: 30 },
  );
});
