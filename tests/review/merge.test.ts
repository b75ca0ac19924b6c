import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { normalize } from '../../editor/core/document/index.ts';
import { mergeLevels } from '../../review/index.ts';
import { formatLevel, isSame, type LevelFile, OBJECT_LISTS, readLevel, withIds } from '../../schema/index.ts';
import { arbitraryFile } from '../editor/arbitrary-file.ts';

const BASE: LevelFile = {
  version: 1,
  name: 'base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: ['aa', 'bb', 'cc'].map((id, i) => ({ id, x: i, y: 0, radius: 16 })),
  runs: [
    { name: 'solution', holds: [[1, 5]] },
    { name: 'other', holds: [] },
  ],
};
type Asteroid = NonNullable<LevelFile['asteroids']>[number];
const rocks = (...asteroids: Asteroid[]): LevelFile => ({ ...BASE, asteroids });
const [aa, bb, cc] = BASE.asteroids as [Asteroid, Asteroid, Asteroid];
const ids = (file: LevelFile) => file.asteroids?.map(({ id }) => id);

/** Changes of a file, each by one side only, which a number selects. */
const arbitraryFork = arbitraryFile.chain((base) =>
  fc
    .record({ base: fc.constant(base), turns: fc.array(fc.nat(3), { minLength: 40, maxLength: 40 }), added: arbitraryFile })
    .map(({ base, turns, added }) => {
      let next = 0;
      const turn = () => turns[next++ % turns.length];
      const [mine, theirs] = [structuredClone(base), structuredClone(base)];
      for (const list of OBJECT_LISTS) {
        for (const { id } of base[list] ?? []) {
          const who = turn();
          if (who > 1) continue;
          const side = [mine, theirs][who];
          const objects = side[list] as { id?: string; x: number }[];
          const index = objects.findIndex((object) => object.id === id);
          if (turn() === 0) objects.splice(index, 1);
          else objects[index].x += objects[index].x > 0 ? -1 : 1;
        }
        // new objects on both sides
        for (const side of [mine, theirs]) {
          const more = (added[list] ?? [])
            .filter(() => turn() === 0)
            .map(({ id: _, ...object }) => ({ ...object, y: side === mine ? 1234.25 : 1234.75 }));
          if (more.length > 0) side[list] = [...(side[list] ?? []), ...more] as never;
        }
      }
      if (turn() === 0) mine.name = 'mine';
      if (turn() === 0) theirs.description = 'theirs';
      if (turn() === 0) mine.astronaut.vy = 5;
      if (turn() === 0) theirs.astronaut.x = 77.5;
      const valid = (file: LevelFile) => {
        const reading = readLevel(formatLevel(file));
        if (!reading.ok) throw new Error(reading.problems[0].message);
        return withIds(reading.document.file);
      };
      return { base, mine: valid(mine), theirs: valid(theirs) };
    }),
);

describe('merging notes', () => {
  const noted = (...notes: [tick: number, text: string][]): LevelFile => ({
    ...BASE,
    runs: [{ name: 'solution', holds: [[1, 5]], notes: notes.map(([tick, text]) => ({ tick, text })) }],
  });
  const notesIn = (base: LevelFile, mine: LevelFile, theirs: LevelFile) => {
    const merged = mergeLevels(base, mine, theirs);
    expect(merged.conflicts).toEqual([]);
    expect(mergeLevels(base, theirs, mine).file).toEqual(merged.file);
    return merged.file.runs?.[0].notes?.map(({ tick, text }) => [tick, text]);
  };
  const base = noted([10, 'a'], [20, 'b'], [20, 'c']);

  it('takes what either side added and removed', () => {
    expect(notesIn(base, noted([10, 'a'], [20, 'b'], [20, 'c'], [15, 'mine']), noted([20, 'c'], [20, 'theirs']))).toEqual([
      [15, 'mine'],
      [20, 'c'],
      [20, 'theirs'],
    ]);
    expect(notesIn(base, noted([10, 'a'], [20, 'b'], [20, 'c'], [9, 'same']), noted([9, 'same'], [10, 'a'], [20, 'c']))).toEqual([
      [9, 'same'],
      [10, 'a'],
      [20, 'c'],
    ]);
  });

  it('keeps both versions of a note that one side moves and the other rewords', () => {
    expect(notesIn(base, noted([12, 'a'], [20, 'b'], [20, 'c']), noted([10, 'A'], [20, 'b'], [20, 'c']))).toEqual([
      [10, 'A'],
      [12, 'a'],
      [20, 'b'],
      [20, 'c'],
    ]);
  });

  it('leaves holds to their own rule', () => {
    const run = (holds: [number, number][], text: string): LevelFile => ({
      ...BASE,
      runs: [{ name: 'solution', holds, notes: [{ tick: 1, text }] }],
    });
    const { conflicts, file } = mergeLevels(run([[1, 5]], 'a'), run([[1, 6]], 'b'), run([[1, 7]], 'c'));
    expect(conflicts.map(({ key }) => key)).toEqual(['runs/solution/holds']);
    expect(file.runs?.[0].notes?.map(({ text }) => text)).toEqual(['b', 'c']);
  });

  it('asks where both together have more notes than a run can have', () => {
    const side = (from: number) => noted(...Array.from({ length: 600 }, (_, i): [number, string] => [from + i, 'x']));
    const { conflicts } = mergeLevels(noted(), side(0), side(1000));
    expect(conflicts.map(({ key }) => key)).toEqual(['runs/solution/notes']);
  });
});

describe('merging', () => {
  it('takes the side that changed, whichever it is, and equal changes of both', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryFile, (base, a) => {
        expect(mergeLevels(base, a, base)).toEqual({ file: a, conflicts: [] });
        expect(mergeLevels(base, base, a)).toEqual({ file: a, conflicts: [] });
        expect(mergeLevels(base, a, a)).toEqual({ file: a, conflicts: [] });
      }),
      { numRuns: 40 },
    );
  });

  it('has no conflict for separate changes, and does not depend on which side is mine', () => {
    fc.assert(
      fc.property(arbitraryFork, ({ base, mine, theirs }) => {
        const one = mergeLevels(base, mine, theirs);
        const other = mergeLevels(base, theirs, mine);
        expect(one.conflicts).toEqual([]);
        expect(isSame(one.file, other.file)).toBe(true);
        // merging again changes nothing
        expect(isSame(mergeLevels(mine, one.file, mine).file, one.file)).toBe(true);
        expect(mergeLevels(theirs, one.file, theirs).conflicts).toEqual([]);
        expect(normalize(one.file, null)).toMatchObject({ ok: true });
        // the additions of both sides are there
        for (const list of OBJECT_LISTS) {
          const kept = new Set(one.file[list]?.map(({ id }) => id));
          const old = new Set(base[list]?.map(({ id }) => id));
          for (const side of [mine, theirs])
            for (const { id } of side[list] ?? []) if (!old.has(id)) expect(kept.has(id)).toBe(true);
        }
      }),
      { numRuns: 40 },
    );
  });

  it('always gives a level, and takes the chosen side in every conflict', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryFile, arbitraryFile, (base, mine, theirs) => {
        const { file, conflicts } = mergeLevels(base, mine, theirs);
        expect(normalize(file, null)).toMatchObject({ ok: true });
        const chosen = mergeLevels(base, mine, theirs, new Map(conflicts.map(({ key }) => [key, 'theirs'])));
        expect(chosen.conflicts.map(({ key }) => key)).toEqual(conflicts.map(({ key }) => key));
        // the values that they have are theirs everywhere
        expect(isSame(mergeLevels(base, theirs, mine).file, chosen.file)).toBe(true);
      }),
      { numRuns: 40 },
    );
  });

  it('combines changes of different properties and of different objects', () => {
    const mine = rocks({ ...aa, x: 50 }, bb, cc);
    const theirs = rocks({ ...aa, radius: 32 }, { ...bb, hot: true }, cc);
    expect(mergeLevels(BASE, mine, theirs)).toEqual({
      file: rocks({ ...aa, x: 50, radius: 32 }, { ...bb, hot: true }, cc),
      conflicts: [],
    });
  });

  it('reports a conflict for each property that both changed; a place is one property', () => {
    const mine = rocks({ ...aa, x: 50, radius: 20 }, bb, cc);
    const theirs = rocks({ ...aa, y: 70, radius: 30 }, bb, cc);
    const { conflicts, file } = mergeLevels(BASE, mine, theirs);
    expect(conflicts).toEqual([
      {
        key: 'asteroids/aa/place',
        what: 'asteroid aa, place',
        base: { x: 0, y: 0 },
        mine: { x: 50, y: 0 },
        theirs: { x: 0, y: 70 },
      },
      { key: 'asteroids/aa/radius', what: 'asteroid aa, radius', base: 16, mine: 20, theirs: 30 },
    ]);
    expect(file).toEqual(mine);
    const chosen = mergeLevels(BASE, mine, theirs, new Map([['asteroids/aa/radius', 'theirs']]));
    expect(chosen.file.asteroids?.[0]).toMatchObject({ x: 50, y: 0, radius: 30 });
  });

  it('reports a conflict if one side removed what the other changed', () => {
    const { conflicts, file } = mergeLevels(BASE, rocks(bb, cc), rocks({ ...aa, x: 9 }, bb, cc));
    expect(conflicts).toMatchObject([{ key: 'asteroids/aa', mine: undefined, theirs: { x: 9 } }]);
    expect(ids(file)).toEqual(['bb', 'cc']);
    expect(
      ids(mergeLevels(BASE, rocks(bb, cc), rocks({ ...aa, x: 9 }, bb, cc), new Map([['asteroids/aa', 'theirs']])).file),
    ).toEqual(['aa', 'bb', 'cc']);
  });

  it('keeps the order of the side that changed it, and reports a conflict if both did', () => {
    expect(ids(mergeLevels(BASE, rocks(cc, aa, bb), rocks(aa, bb, cc, { ...aa, id: 'dd' })).file)).toEqual([
      'cc',
      'dd',
      'aa',
      'bb',
    ]);
    expect(mergeLevels(BASE, rocks(cc, aa, bb), rocks(bb, aa, cc)).conflicts).toMatchObject([{ key: 'order/asteroids' }]);
  });

  it('names the astronaut, the black hole and the level in conflicts', () => {
    const mine = { ...BASE, name: 'm', astronaut: { x: 1, y: 0 }, blackHole: { x: 301, y: 0, radius: 20 } };
    const theirs = { ...BASE, name: 't', astronaut: { x: 2, y: 0, vx: 5 }, blackHole: { x: 300, y: 0, radius: 30 } };
    const { conflicts, file } = mergeLevels(BASE, mine, theirs);
    expect(conflicts.map(({ key, what }) => [key, what])).toEqual([
      ['name', 'name'],
      ['astronaut/place', 'astronaut, place'],
      ['blackHole/radius', 'black hole, radius'],
    ]);
    expect(file).toMatchObject({ name: 'm', astronaut: { x: 1, y: 0, vx: 5 }, blackHole: { x: 301, y: 0, radius: 20 } });
  });

  it('puts additions of both sides at one place in a fixed order, whichever side is mine', () => {
    const [dd, ee] = ['dd', 'ee'].map((id) => ({ ...aa, id }));
    for (const [mine, theirs] of [
      [rocks(aa, dd, bb, cc), rocks(aa, ee, bb, cc)],
      [rocks(aa, ee, bb, cc), rocks(aa, dd, bb, cc)],
    ])
      expect(ids(mergeLevels(BASE, mine, theirs).file)).toEqual(['aa', 'dd', 'ee', 'bb', 'cc']);
    // before all others, and after the last
    expect(ids(mergeLevels(BASE, rocks(dd, aa, bb, cc), rocks(aa, bb, cc, ee)).file)).toEqual(['dd', 'aa', 'bb', 'cc', 'ee']);
  });

  it('identifies runs by name, and treats their holds as one value', () => {
    const runs = (...list: [string, [number, number][]][]): LevelFile => ({
      ...BASE,
      runs: list.map(([name, holds]) => ({ name, holds })),
    });
    const mine = runs(['solution', [[1, 9]]], ['other', []]);
    expect(mergeLevels(BASE, mine, runs(['solution', [[1, 5]]], ['other', []], ['new', [[3, 4]]])).file).toEqual(
      runs(['solution', [[1, 9]]], ['other', []], ['new', [[3, 4]]]),
    );
    expect(mergeLevels(BASE, mine, runs(['solution', [[2, 5]]], ['other', []])).conflicts).toMatchObject([
      { key: 'runs/solution/holds', what: 'run solution, holds' },
    ]);
  });
});
