import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Change, diffLevels, takeBack } from '../../review/index.ts';
import { formatLevel, type LevelFile, OBJECT_LISTS } from '../../schema/index.ts';
import { arbitraryFile } from '../editor/arbitrary-file.ts';
import { apply, arbitraryEdits } from './arbitrary-edits.ts';

/** A level with ids, and what random edits make of it. */
const edited = fc.tuple(arbitraryFile, arbitraryEdits(25)).map(([before, edits]) => {
  const after = structuredClone(before);
  for (const edit of edits) apply(after, edit);
  return { before, after };
});

type Entry = { readonly id?: string; readonly name?: string };

const entriesOf = (file: LevelFile): Map<string, readonly Entry[]> =>
  new Map([...OBJECT_LISTS, 'runs' as const].map((list) => [list, (file[list] ?? []) as readonly Entry[]]));

const keyOf = ({ id, name }: Entry): string => id ?? name ?? '';

describe('changes that are taken back', () => {
  it('make the first version of the second if all of them are, and nothing if none is', () => {
    fc.assert(
      fc.property(edited, ({ before, after }) => {
        const changes = diffLevels(before, after);
        expect(formatLevel(takeBack(before, after, changes))).toBe(formatLevel(before));
        expect(formatLevel(takeBack(before, after, []))).toBe(formatLevel(after));
      }),
      { numRuns: 120 },
    );
  });

  it('leave every other object and run as it is, and put what comes back between its neighbours', () => {
    fc.assert(
      fc.property(edited, fc.array(fc.boolean(), { minLength: 40, maxLength: 40 }), ({ before, after }, dice) => {
        const changes = diffLevels(before, after);
        const chosen = changes.filter((change, i) => dice[i % dice.length] && change.type !== 'order');
        const result = takeBack(before, after, chosen);
        const now = entriesOf(result);
        const touched = (list: string, key: string): Change | undefined =>
          chosen.find((change) => {
            if (!('of' in change) || change.of !== list) return false;
            if (change.type === 'added' || change.type === 'removed') return keyOf(change.entry as Entry) === key;
            const index = change.type === 'changed' ? change.after : -1;
            return index >= 0 && keyOf(entriesOf(after).get(list)?.[index] ?? {}) === key;
          });
        for (const [list, entries] of entriesOf(after)) {
          for (const entry of entries) {
            const change = touched(list, keyOf(entry));
            const found = now.get(list)?.find((one) => keyOf(one) === keyOf(entry));
            if (change === undefined) expect(found).toEqual(entry);
            else if (change.type === 'added') expect(found).toBeUndefined();
          }
        }
        for (const [list, entries] of entriesOf(before)) {
          const keys = (now.get(list) ?? []).map(keyOf);
          for (const [i, entry] of entries.entries()) {
            if (touched(list, keyOf(entry))?.type !== 'removed') continue;
            expect(now.get(list)).toContainEqual(entry);
            // it stands behind the nearest of its former predecessors that is there
            const previous = entries
              .slice(0, i)
              .map(keyOf)
              .findLast((key) => keys.includes(key));
            if (previous !== undefined) expect(keys.indexOf(previous)).toBeLessThan(keys.indexOf(keyOf(entry)));
          }
        }
      }),
      { numRuns: 120 },
    );
  });

  it('give an order back without losing what was added since', () => {
    const object = (id: string, x: number) => ({ id, x, y: 0, radius: 9 });
    const level = (...asteroids: ReturnType<typeof object>[]) =>
      ({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 9, y: 9 }, asteroids }) as LevelFile;
    const before = level(object('a', 1), object('b', 2), object('c', 3));
    const after = level(object('c', 3), object('n', 4), object('b', 2), object('a', 1));
    const order = diffLevels(before, after).filter(({ type }) => type === 'order');
    expect(takeBack(before, after, order).asteroids?.map(({ id }) => id)).toEqual(['a', 'b', 'c', 'n']);
  });

  it('of one field leave the other fields of the object', () => {
    const level = (x: number, radius: number) =>
      ({
        version: 1,
        name: 'a',
        astronaut: { x: 0, y: 0 },
        blackHole: { x: 9, y: 9 },
        asteroids: [{ id: 'a', x, y: 0, radius }],
      }) as LevelFile;
    const [before, after] = [level(1, 9), level(5, 12)];
    const [change] = diffLevels(before, after);
    if (change.type !== 'changed') throw new Error('the asteroid changed');
    const part = { ...change, fields: change.fields.filter(({ key }) => key === 'radius') };
    expect(takeBack(before, after, [part]).asteroids).toEqual([{ id: 'a', x: 5, y: 0, radius: 9 }]);
  });

  it('of something that is not there are refused', () => {
    const file = { version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 9, y: 9 } } as LevelFile;
    const change: Change = { type: 'added', of: 'asteroids', index: 3, entry: { id: 'a' } };
    expect(() => takeBack(file, file, [change])).toThrow(RangeError);
  });
});
