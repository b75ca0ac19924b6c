import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { formatLevel, type LevelFile, readLevel } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { BASE } from './base-level.ts';

function read(text: string): LevelFile {
  const reading = readLevel(text);
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading.document.file;
}

/** The value as in JSON: without undefined keys, and with 0 for -0. */
const plain = (value: unknown): unknown => JSON.parse(JSON.stringify(value));

describe('the canonical text', () => {
  test('is the text of the base level', () => {
    expect(formatLevel(read(BASE))).toBe(BASE);
  });

  test('has ordered keys, lists in their order, and unchanged x- keys last', () => {
    const text = `{"x-a":{"b":[1,{"c":null}],"x-z":[]},"runs":[{"x-r":0,"holds":[],"name":"n"}],"novae":[{"radius":2.50,"y":-0,"x-k":"ü\\u0007","x":1e3},
      {"x":1,"y":1,"radius":1}],"aliens":[],"blackHole":{"y":0.1,"x":1E-9},"astronaut":{"y":2,"x":1},"name":"a","version":1}`;
    expect(formatLevel(read(text))).toBe(`{
  "version": 1,
  "name": "a",
  "astronaut": { "x": 1, "y": 2 },
  "blackHole": { "x": 1e-9, "y": 0.1 },
  "novae": [
    { "x": 1000, "y": 0, "radius": 2.5, "x-k": "ü\\u0007" },
    { "x": 1, "y": 1, "radius": 1 }
  ],
  "aliens": [],
  "runs": [
    {
      "name": "n",
      "holds": [],
      "x-r": 0
    }
  ],
  "x-a": { "b": [1, { "c": null }], "x-z": [] }
}
`);
  });

  test('reads back as the same file, and is itself canonical', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const text = formatLevel(file);
        const again = read(text);
        expect(again).toEqual(plain(file));
        expect(formatLevel(again)).toBe(text);
        expect(text.endsWith('}\n')).toBe(true);
        expect(text).not.toMatch(/\r|[ \t]\n/);
      }),
      { numRuns: 120 },
    );
  });

  test('sorts notes by tick, keeps those of one tick in their order, and puts each on a line', () => {
    const notes = '[{"x-c":1,"text":"late","tick":9},{"tick":4,"text":"b"},{"tick":4,"text":"a"}]';
    const text = `{"runs":[{"notes":${notes},"holds":[],"name":"n"}],"blackHole":{"y":0,"x":1},"astronaut":{"y":2,"x":1},"name":"a","version":1}`;
    expect(formatLevel(read(text))).toContain(`    {
      "name": "n",
      "holds": [],
      "notes": [
        { "tick": 4, "text": "b" },
        { "tick": 4, "text": "a" },
        { "tick": 9, "text": "late", "x-c": 1 }
      ]
    }`);
  });

  test('changes in one line if one object moves', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.nat(), fc.double({ min: -1000, max: 1000, noNaN: true }), (file, pick, x) => {
        const before = plain(file) as LevelFile;
        const after = plain(file) as LevelFile;
        const objects = [after.astronaut, after.blackHole, ...(after.asteroids ?? []), ...(after.minerals ?? [])];
        const moved = objects[pick % objects.length];
        fc.pre(moved.x !== x + 0);
        moved.x = x;
        const [a, b] = [formatLevel(before).split('\n'), formatLevel(after).split('\n')];
        expect(b).toHaveLength(a.length);
        expect(b.filter((line, i) => line !== a[i])).toHaveLength(1);
      }),
      { numRuns: 80 },
    );
  });

  test('changes in one line if a hold changes', () => {
    const a = BASE.split('\n');
    const file = read(BASE);
    file.runs![0].holds[1] = [131, 190];
    expect(
      formatLevel(file)
        .split('\n')
        .filter((line, i) => line !== a[i]),
    ).toEqual(['        [131, 190]']);
  });

  test('keeps an own __proto__ inside an x- key', () => {
    const file = read(BASE.replace('"range"', '"x-a": { "__proto__": { "b": 1 } },\n  "range"'));
    expect(formatLevel(file)).toContain('  "x-a": { "__proto__": { "b": 1 } }\n');
  });

  test('refuses numbers that JSON can’t hold', () => {
    const file = read(BASE);
    file.astronaut.x = Number.NaN;
    expect(() => formatLevel(file)).toThrow(RangeError);
  });
});
