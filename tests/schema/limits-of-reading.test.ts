import { describe, expect, test } from 'vitest';
import { toWords } from '../../schema/basics/names.ts';
import { importOriginal, type Problem, readLevel } from '../../schema/index.ts';

const small = (rest: string) => `{"version":1,"name":"a","astronaut":{"x":1,"y":2},"blackHole":{"x":1,"y":3}${rest}}`;
const problemsOf = (source: string | Uint8Array): Problem[] => {
  const reading = readLevel(source);
  if (reading.ok) throw new Error('was read');
  return reading.problems;
};
/** The number of problems, according to the last of them. */
const rest = (problems: readonly Problem[]) => problems.at(-1)?.message;
const imported = (...levels: unknown[]) => {
  const reading = importOriginal(JSON.stringify(levels), { recoil: false });
  if (reading.ok) throw new Error('was imported');
  return rest(reading.problems);
};

describe('a file with thousands of problems', () => {
  const places = { player: { x: 1, y: 2 }, target: { x: 1, y: 2 } };
  const wrong = (count: number) => Array(count).fill(7);
  // each has no radius
  const bare = (count: number) => Array(count).fill({ x: 1, y: 2 });

  test('of the original is read until 1000 problems are found, whatever they are', () => {
    expect(imported({ ...places, novae: wrong(999) })).toBe('and 979 more');
    for (const list of [wrong(1000), wrong(1100), bare(1000), bare(1100)]) {
      expect(imported({ ...places, novae: list })).toBe('and at least 980 more');
      expect(imported({ ...places, novae: list, aliens: 5, maxDistance: 'x' })).toBe('and at least 980 more');
      expect(imported({ ...places, novae: list }, {}, { player: places.player }, 7)).toBe('and at least 980 more');
    }
  });

  test('of this format is treated in the same way', () => {
    const of = (lists: object) => rest(problemsOf(small(`,${JSON.stringify(lists).slice(1, -1)}`)));
    const holds = (list: unknown[]) => ({ runs: [{ name: 'a', holds: list }] });
    expect(of({ novae: wrong(999) })).toBe('and 979 more');
    expect(of(holds(wrong(999)))).toBe('and 979 more');
    for (const count of [1000, 1100]) {
      for (const lists of [
        { novae: wrong(count) },
        { novae: bare(count) },
        { runs: wrong(count > 1000 ? 1000 : count) },
        holds(wrong(count)),
      ])
        expect(of({ ...lists, aliens: wrong(3) })).toMatch(/and at least 98\d more/);
    }
    const keys = Object.fromEntries(Array.from({ length: 1100 }, (_, i) => [`key${i}`, i]));
    expect(of(keys)).toBe('and at least 980 more');
  });

  test('gets 20 problems reported, and the number of the others', () => {
    expect(problemsOf(small(`,"novae":[${wrong(20)}]`))).toHaveLength(20);
    expect(rest(problemsOf(small(`,"novae":[${wrong(21)}]`)))).toBe('and 1 more');
  });
});

describe('a list', () => {
  const count = (key: string, entry: string, length: number) => {
    const reading = readLevel(small(`,"${key}":[${Array(length).fill(entry)}]`));
    return reading.ok || reading.problems.map(({ message }) => message);
  };
  test('may have as many entries as the format allows, and no more', () => {
    const nova = '{"x":1,"y":2,"radius":3}';
    expect(count('novae', nova, 20_000)).toBe(true);
    expect(count('novae', nova, 20_001)).toEqual(['novae: expected at most 20000 entries, found 20001']);
    const places = '"player":{"x":1,"y":2},"target":{"x":1,"y":2}';
    const original = (length: number) =>
      importOriginal(`{${places},"novae":[${Array(length).fill(nova)}]}`, { recoil: false }).ok;
    expect([20_000, 20_001].map(original)).toEqual([true, false]);
  });

  test('of the original is omitted if it is empty', () => {
    const reading = importOriginal('{"player":{"x":1,"y":2},"target":{"x":1,"y":2},"novae":[],"aliens":[{"x":1,"y":2}]}', {
      recoil: false,
    });
    if (!reading.ok) throw new Error('was not imported');
    expect(reading.levels[0].file).toMatchObject({ novae: undefined, aliens: [{ x: 1, y: 2 }] });
  });
});

describe('the pointer of a problem', () => {
  test('is that of the surrounding value if a key makes it longer than 500 characters', () => {
    const pointer = (length: number) => problemsOf(small(`,"${'k'.repeat(length)}":1`))[0].pointer;
    expect(pointer(499)).toBe(`/${'k'.repeat(499)}`);
    expect(pointer(500)).toBe('');
    const inner = problemsOf(small(`,"novae":[{"x":1,"y":2,"radius":3,"${'k'.repeat(500)}":1}]`))[0];
    expect(inner.pointer).toBe('/novae/0');
  });

  test('is given in words, with quotes around keys that are not words', () => {
    expect(toWords([])).toBe('');
    expect(toWords(['asteroids', 3, 'radius'])).toBe('asteroid 4, radius');
    expect(toWords(['blackHole', 'x'])).toBe('black hole, x');
    expect(toWords(['runs', 0, 'holds', 1, 0])).toBe('run 1, hold 2, press');
    expect(toWords(['a b', 0, 'c', 'd"'])).toBe('"a b", entry 1, c, "d\\""');
    expect(toWords(['$schema', 'x-note'])).toBe('$schema, x-note');
  });

  test('names a run by its name, or by its number if two have the same name', () => {
    const path = ['runs', 1, 'holds', 2, 1];
    expect(toWords(path, { runs: [{ name: 'solution' }, { name: 'other' }] })).toBe('run "other", hold 3, release');
    expect(toWords(path, { runs: [{ name: 'other' }, { name: 'other' }] })).toBe('run 2, hold 3, release');
    for (const name of ['', 7, undefined]) expect(toWords(path, { runs: [null, { name }] })).toBe('run 2, hold 3, release');
    for (const level of [null, { runs: 7 }, { runs: [] }]) expect(toWords(path, level)).toBe('run 2, hold 3, release');
  });
});

describe('bytes that are not UTF-8', () => {
  const messageOf = (...bytes: number[]) => problemsOf(Uint8Array.from(bytes))[0].message;

  test('look like UTF-16 if they begin with one of its two marks', () => {
    const marks = [0xff, 0xfe, 0x41, 0xe9];
    const found = marks.flatMap((a) => marks.flatMap((b) => (messageOf(a, b, 0xff).includes('UTF-16') ? [[a, b]] : [])));
    expect(found).toEqual([
      [0xff, 0xfe],
      [0xfe, 0xff],
    ]);
    expect([messageOf(0xff), messageOf(0xff, 0xfe)].map((message) => message.includes('UTF-16'))).toEqual([false, true]);
    expect(messageOf(0x41, 0xff, 0xfe)).toBe('the byte FF at offset 1 is not UTF-8');
  });

  test('are found at their place, also after a byte order mark', () => {
    const mark = [0xef, 0xbb, 0xbf];
    const place = (options: Parameters<typeof readLevel>[1], ...bytes: number[]) => {
      const reading = readLevel(Uint8Array.from(bytes), options);
      return reading.ok ? [] : reading.problems.map(({ line, column, message }) => `${line}:${column} ${message}`);
    };
    expect(place({}, 0x7b, 0x0a, 0x20, 0xff)).toEqual(['2:2 the byte FF at offset 3 is not UTF-8']);
    expect(place({ byteOrderMark: 'skip' }, ...mark, 0x7b, 0xff)).toEqual(['1:2 the byte FF at offset 4 is not UTF-8']);
    expect(place({}, ...mark, 0x7b, 0x05, 0xff)).toEqual([
      '1:1 the file begins with a byte order mark (EF BB BF)',
      '1:3 the byte FF at offset 5 is not UTF-8',
    ]);
  });
});
