import fc from 'fast-check';
import { expect, it } from 'vitest';
import { inOrderOfPlay } from '../../cli/io/level-names.ts';
import { inSafeOrder, namesInOrder } from '../../cli/serve/reorder.ts';

const word = fc.stringMatching(/^[a-c]{1,3}$/);
const name = fc.oneof(
  word,
  fc
    .tuple(fc.integer({ min: 0, max: 120 }), fc.constantFrom('', '0', '00'), fc.constantFrom('-', ' ', '_', '.'), word)
    .map(([n, zeros, sep, w]) => `${zeros}${n}${sep}${w}`),
  fc.integer({ min: 0, max: 30 }).map(String),
  fc.tuple(fc.integer({ min: 0, max: 30 }), word).map(([n, w]) => `${n}${w}`),
);
const names = fc.uniqueArray(name, { maxLength: 12 }).chain((all) => fc.shuffledSubarray(all, { minLength: all.length }));

it('names sort as wanted, are all different, and keep their text', () => {
  fc.assert(
    fc.property(names, (wanted) => {
      const named = namesInOrder(wanted);
      expect(named.toSorted(inOrderOfPlay)).toEqual(named);
      expect(new Set(named).size).toBe(wanted.length);
      for (const [i, old] of wanted.entries()) {
        const words = /[a-c]*$/.exec(old)?.[0] ?? '';
        expect(named[i].endsWith(words)).toBe(true);
      }
      // names that are in order stay the same
      expect(namesInOrder(named)).toEqual(named);
    }),
    { numRuns: 2000 },
  );
});

it('keeps existing gaps, and names that need not change', () => {
  expect(namesInOrder(['30-c', '10-a', '20-b'])).toEqual(['10-c', '20-a', '30-b']);
  expect(namesInOrder(['01-a', '03-c', '02-b', '04-d'])).toEqual(['01-a', '02-c', '03-b', '04-d']);
  expect(namesInOrder(['b', 'a'])).toEqual(['01-b', '02-a']);
  expect(namesInOrder(['a', 'b'])).toEqual(['a', 'b']);
});

it('moves each file to its place, and never onto one that still has to move', () => {
  const permutation = fc.integer({ min: 1, max: 9 }).chain((n) => {
    const all = Array.from({ length: n }, (_, i) => `f${i}`);
    return fc
      .shuffledSubarray([...all, 'free1', 'free2', 'free3'], { minLength: n, maxLength: n })
      .map((to) => all.map((from, i) => ({ from, to: to[i] })));
  });
  fc.assert(
    fc.property(permutation, (moves) => {
      const disk = new Map(moves.map(({ from }) => [from, from]));
      for (const { from, to } of inSafeOrder(moves, (taken) => `${taken}-aside`)) {
        expect(disk.has(from)).toBe(true);
        expect(disk.has(to)).toBe(false);
        disk.set(to, disk.get(from) as string);
        disk.delete(from);
      }
      expect([...disk].sort()).toEqual(moves.map(({ from, to }) => [to, from]).sort());
    }),
    { numRuns: 1000 },
  );
});
