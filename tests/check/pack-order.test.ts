import { readdirSync, readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  addChapter,
  addLevels,
  chaptersOf,
  EFFECT_NAMES,
  effectsToMeet,
  inPackOrder,
  introductionsOf,
  JUMP,
  jumpsOf,
  type MetLevel,
  moveEntries,
  packProblems,
  removeEntries,
  removeLevels,
  renameLevel,
  setChapter,
  shownEntries,
} from '../../check/pack/index.ts';
import { compile } from '../../engine/index.ts';
import { formatPack, levelOfEntry, levelsOfPack, type PackFile, readLevel, readPack } from '../../schema/index.ts';

const LEVELS = new URL('../../levels/', import.meta.url);

const packOf = (...levels: PackFile['levels']): PackFile => ({ version: 1, name: 'Test', levels });

function problems(pack: PackFile, levels: readonly MetLevel[]): string[] {
  const reading = readPack(formatPack(pack));
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return packProblems(reading, levels).map(({ code, severity, line, message }) => `${line} ${severity} ${code}: ${message}`);
}

const met = (id: string, ...effects: string[]): MetLevel => ({ id, effects });

const ids = fc.uniqueArray(fc.constantFrom('a', 'b', 'c', 'd', 'w/a', 'w/b', '01-x', '02-y'), { maxLength: 8 });
const effects = fc.option(fc.subarray([...EFFECT_NAMES]), { nil: null, freq: 8 });
const entry = fc.oneof(
  { weight: 4, arbitrary: fc.constantFrom('a', 'b', 'c', 'd', 'w/a', 'w/b', '01-x', '02-z') },
  fc.constant({ chapter: 'C' }),
  fc.record({ level: fc.constantFrom('a', 'b', 'w/a'), introduces: fc.subarray([...EFFECT_NAMES, 'nova'], { minLength: 1 }) }),
);
const pack: fc.Arbitrary<PackFile> = fc.array(entry, { maxLength: 10 }).map((levels) => packOf(...levels));

describe('the problems of a pack', () => {
  const folder = [met('01-a'), met('02-b', 'minerals'), met('03-c', 'minerals', 'novae', 'recoil')];

  it('are none where every level is listed once and introduces at most one thing', () => {
    expect(problems(packOf('01-a', '02-b', { level: '03-c', introduces: ['novae', 'recoil'] }), folder)).toEqual([]);
  });

  it('name a level that is not there, with what was meant', () => {
    const found = problems(packOf('01-a', '02-bb', '03-c.level.json', 'nothing-like-it'), folder);
    expect(found.filter((text) => text.includes('missing'))).toEqual([
      '6 error pack-missing-level: there is no level "02-bb" in this folder: did you mean "02-b"?',
      '7 error pack-missing-level: there is no level "03-c.level.json" in this folder: did you mean "03-c"?',
      '8 error pack-missing-level: there is no level "nothing-like-it" in this folder',
    ]);
  });

  it('name a level that is listed twice, one that is not listed, and an empty chapter', () => {
    expect(problems(packOf({ chapter: 'Empty' }, { chapter: 'Full' }, '02-b', '02-b', { chapter: 'End' }), folder)).toEqual([
      '4 warning pack-unlisted-level: 2 levels of this folder are not listed: "01-a" and "03-c"',
      '5 warning pack-empty-chapter: the chapter "Empty" has no level',
      '8 error pack-repeated-level: the level "02-b" is listed twice: entry 3 and entry 4',
      '9 warning pack-empty-chapter: the chapter "End" has no level',
    ]);
  });

  it('say when a level introduces several things at once, unless it is meant to', () => {
    const crowded =
      '7 warning pack-introduction: "03-c" is the first level with novae and recoil: players meet two new things at once';
    expect(problems(packOf('01-a', '02-b', '03-c'), folder)).toEqual([crowded]);
    expect(problems(packOf('01-a', '02-b', { level: '03-c', introduces: ['novae'] }), folder)).toEqual([crowded]);
  });

  it('say when a level does not introduce what it is meant to', () => {
    const declared = (level: string, ...introduces: string[]) => ({ level, introduces });
    expect(problems(packOf(declared('01-a', 'novae'), '02-b', declared('03-c', 'minerals', 'novae', 'recoil')), folder)).toEqual([
      '5 warning pack-introduction: "01-a" is meant to introduce novae, but it does not call for it',
      '7 warning pack-introduction: "03-c" is meant to introduce minerals, but players meet it in "02-b" before',
    ]);
    expect(problems(packOf('01-a', declared('02-b', 'mineral'), declared('03-c', 'novae', 'recoil')), folder)).toEqual([
      '6 error unknown-value: no effect is called "mineral": did you mean "minerals"?',
    ]);
  });

  it('say nothing of introductions after a level that is not known, which may be the first with anything', () => {
    const unknown = [{ id: '01-a', effects: null }, ...folder.slice(1)];
    expect(problems(packOf('01-a', '02-b', '03-c'), unknown)).toEqual([]);
  });

  it('all have a place in the text, in its order, whatever the pack and the folder', () => {
    fc.assert(
      fc.property(pack, ids, fc.infiniteStream(effects), (value, there, stream) => {
        const levels = there.map((id): MetLevel => ({ id, effects: stream.next().value }));
        const text = formatPack(value);
        const reading = readPack(text);
        if (!reading.ok) throw new Error('expected a valid pack');
        const found = packProblems(reading, levels);
        const rows = text.split('\n');
        for (const { line, column, pointer, message, hint } of found) {
          expect(line).toBeGreaterThanOrEqual(1);
          expect(column).toBeLessThanOrEqual(rows[(line ?? 1) - 1].length);
          expect(pointer).toMatch(/^\/levels/);
          expect(message).not.toBe('');
          expect(hint).not.toBe('');
        }
        const lines = found.map(({ line }) => line ?? 0);
        expect(lines).toEqual([...lines].sort((a, b) => a - b));
        // the order in which the folder is read says nothing
        expect(packProblems(reading, [...levels].reverse())).toEqual(found);
        // counted in another way
        const listed = value.levels.flatMap((one) => levelOfEntry(one) ?? []);
        const count = (code: string) => found.filter((one) => one.code === code).length;
        expect(count('pack-missing-level')).toBe(listed.filter((id) => !there.some((one) => one === id)).length);
        expect(count('pack-repeated-level')).toBe(listed.length - new Set(listed).size);
        expect(count('pack-unlisted-level')).toBe(there.some((id) => !listed.includes(id)) ? 1 : 0);
      }),
    );
  });
});

describe('what a level introduces', () => {
  it('is met in no level before it, and in every level after it that calls for it nothing is new', () => {
    fc.assert(
      fc.property(ids, fc.infiniteStream(effects), (order, stream) => {
        const levels = order.map((id): MetLevel => ({ id, effects: stream.next().value }));
        const first = introductionsOf(levels);
        for (const [i, { id, effects: own }] of levels.entries()) {
          const before = levels.slice(0, i + 1).map((level) => level.effects);
          if (before.includes(null)) expect(first.has(id)).toBe(false);
          else {
            const known = new Set(before.slice(0, -1).flat());
            expect(first.get(id)).toEqual((own ?? []).filter((name) => !known.has(name)));
          }
        }
      }),
    );
  });

  it('counts effects that some level does without: those that the engine leaves out of some shipped level', () => {
    const levels = readdirSync(LEVELS)
      .filter((file) => file.endsWith('.level.json'))
      .map((file) => {
        const reading = readLevel(readFileSync(new URL(file, LEVELS)));
        if (!reading.ok) throw new Error(file);
        return reading.level;
      });
    const simulated = levels.map((level) => compile(level).effects.simulated.map(({ name }) => name));
    const always = simulated[0].filter((name) => simulated.every((names) => names.includes(name)));
    for (const name of always) expect(EFFECT_NAMES).not.toContain(name);
    for (const [i, level] of levels.entries())
      expect(effectsToMeet(level)).toEqual(simulated[i].filter((name) => !always.includes(name)));
  });
});

describe('changes of a pack', () => {
  const folderOf = (value: PackFile, there: readonly string[]) => [...new Set([...levelsOfPack(value), ...there])].sort();

  it('move entries: none is lost or doubled, the others keep their order, and moving back is identity', () => {
    fc.assert(
      fc.property(pack, ids, fc.array(fc.nat(17), { maxLength: 4 }), fc.nat(18), (value, there, some, to) => {
        const all = folderOf(value, there);
        const shown = shownEntries(value, all);
        const moved = [...new Set(some.filter((place) => place < shown.length))].sort((a, b) => a - b);
        const before = Math.min(to, shown.length);
        const next = moveEntries(value, all, moved, before);
        const after = shownEntries(next, all).map(({ entry: one }) => one);
        const key = (one: unknown) => JSON.stringify(one);
        expect(after.map(key).sort()).toEqual(shown.map(({ entry: one }) => key(one)).sort());
        // by another way: a list with a mark where they go
        const marked = shown.flatMap(({ entry: one }, i) => [
          ...(i === before ? ['mark'] : []),
          ...(moved.includes(i) ? [] : [one]),
        ]);
        if (before === shown.length) marked.push('mark');
        const wanted = marked.flatMap((one) => (one === 'mark' ? moved.map((i) => shown[i].entry) : [one]));
        const cut = next.levels.length;
        expect(next.levels).toEqual(wanted.slice(0, cut));
        // what was listed, or was moved, is listed
        for (const [i, one] of shown.entries())
          if (one.isListed || moved.includes(i)) expect(next.levels.map(key)).toContain(key(one.entry));
        if (moved.length === 1 && shown[moved[0]].isListed) {
          const [from] = moved;
          const now = from < before ? before - 1 : before;
          const back = moveEntries(next, all, [now], from < before ? from : from + 1);
          expect(back.levels.slice(0, value.levels.length)).toEqual(value.levels);
        }
      }),
    );
  });

  it('add, rename and remove levels, and leave everything else of the file', () => {
    const value = { ...packOf('a', { chapter: 'C' }, { level: 'b', introduces: ['novae'] }, 'c'), 'x-note': 'mine' };
    expect(addLevels(value, ['d', 'a'], 'a').levels).toEqual(['a', 'd', { chapter: 'C' }, value.levels[2], 'c']);
    expect(addLevels(value, ['d']).levels.at(-1)).toBe('d');
    expect(renameLevel(value, 'b', 'e').levels[2]).toEqual({ level: 'e', introduces: ['novae'] });
    expect(removeLevels(value, ['b', 'a']).levels).toEqual([{ chapter: 'C' }, 'c']);
    expect(removeEntries(value, [1, 3]).levels).toEqual(['a', value.levels[2]]);
    expect(addChapter(value, 3, 'D').levels[3]).toEqual({ chapter: 'D' });
    expect(setChapter(value, 1, 'D').levels[1]).toEqual({ chapter: 'D' });
    expect(setChapter(value, 1, null).levels).toHaveLength(3);
    // a place of a level is no chapter
    expect(setChapter(value, 0, 'D').levels).toEqual(value.levels);
    expect(removeLevels(value, ['a'])).toHaveProperty('x-note', 'mine');
    expect([...chaptersOf(value)]).toEqual([
      ['b', 'C'],
      ['c', 'C'],
    ]);
  });

  it('put listed levels first, and the others after them in their order', () => {
    expect(inPackOrder(['1', '2', '3', '4'], (one) => one, ['3', '9', '1'])).toEqual(['3', '1', '2', '4']);
  });
});

describe('jumps', () => {
  it('are levels far above the hardest before them', () => {
    expect(jumpsOf([1, 3, 2.9, 4.9, null, 5, 8.5])).toEqual([
      { index: 1, from: 0, by: 2 },
      { index: 6, from: 5, by: 3.5 },
    ]);
    expect(jumpsOf([9])).toEqual([]);
    expect(jumpsOf([null, 9, 1])).toEqual([]);
  });

  it('are the same by comparing every pair', () => {
    const grade = fc.option(fc.integer({ min: 10, max: 100 }).map((tenths) => tenths / 10));
    fc.assert(
      fc.property(fc.array(grade, { maxLength: 12 }), (grades) => {
        const far = (a: number, b: number) => Math.round(10 * a) - Math.round(10 * b) >= 10 * JUMP;
        const wanted = [...grades.keys()].filter((i) => {
          const own = grades[i];
          const before = grades.slice(0, i).filter((one) => one !== null);
          return own !== null && before.length > 0 && before.every((one) => far(own, one));
        });
        expect(jumpsOf(grades).map(({ index }) => index)).toEqual(wanted);
      }),
    );
  });
});

it('the shipped pack lists every shipped level and has no problem', () => {
  const reading = readPack(readFileSync(new URL('pack.json', LEVELS)));
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  const levels = readdirSync(LEVELS)
    .filter((file) => file.endsWith('.level.json'))
    .map((file): MetLevel => {
      const level = readLevel(readFileSync(new URL(file, LEVELS)));
      return { id: file.replace('.level.json', ''), effects: level.ok ? effectsToMeet(level.level) : null };
    });
  expect(packProblems(reading, levels)).toEqual([]);
  expect(levelsOfPack(reading.pack)).toHaveLength(levels.length);
});
