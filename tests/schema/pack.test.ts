import { Ajv2020 } from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  formatPack,
  formatPackJsonSchema,
  levelsOfPack,
  type PackEntry,
  type PackFile,
  packJsonSchema,
  packSchema,
  readPack,
} from '../../schema/index.ts';
import { withoutExtensions } from '../../schema/json/values.ts';
import { apply, edit } from './edits.ts';

const id = fc.oneof(
  fc.constantFrom('01-first', 'world-2/01-start', 'toString', '__proto__', 'a"b\\c', 'Å — ü', ' '),
  fc.string({ minLength: 1, maxLength: 20, unit: 'grapheme' }),
);
const name = fc.constantFrom('Gravity Quest', 'a', '  x ', 'Å "quoted" \\', '日本');
const extras = fc.dictionary(fc.constantFrom('x-note', 'x-', 'x-by'), fc.jsonValue(), { noNullPrototype: true });
const entry: fc.Arbitrary<PackEntry> = fc.oneof(
  id,
  fc
    .tuple(
      fc.record({ level: id, introduces: fc.array(id, { minLength: 1, maxLength: 3 }) }, { requiredKeys: ['level'] }),
      extras,
    )
    .map(([own, more]) => ({ ...own, ...more })),
  fc.tuple(fc.record({ chapter: name }), extras).map(([own, more]) => ({ ...own, ...more })),
);
const pack: fc.Arbitrary<PackFile> = fc
  .tuple(
    fc.record(
      {
        $schema: fc.constant('../pack.schema.json'),
        version: fc.constant(1 as const),
        name,
        levels: fc.array(entry, { maxLength: 8 }),
      },
      { requiredKeys: ['version', 'name', 'levels'] },
    ),
    extras,
  )
  .map(([own, more]) => ({ ...own, ...more }));

/** An entry in its shortest form. */
const plain = (one: PackEntry): PackEntry =>
  typeof one === 'object' && 'level' in one && Object.keys(one).length === 1 ? one.level : one;

const problemsOf = (text: string) => {
  const read = readPack(text);
  if (read.ok) throw new Error('expected problems');
  return read.problems.map(({ code, line, column, message }) => `${line}:${column} ${code} ${message}`);
};

describe('a pack file', () => {
  test('is read as it was written, in one canonical layout with a line for each entry', () => {
    const validate = new Ajv2020({ strict: false }).compile(packJsonSchema());
    fc.assert(
      fc.property(pack, (value) => {
        const text = formatPack(value);
        const read = readPack(text);
        if (!read.ok) throw new Error(JSON.stringify(read.problems));
        expect(JSON.parse(text)).toEqual(JSON.parse(JSON.stringify({ ...value, levels: value.levels.map(plain) })));
        expect(formatPack(read.pack)).toBe(text);
        expect(validate(JSON.parse(text)), JSON.stringify(validate.errors)).toBe(true);
        const rows = text.split('\n').filter((line) => line.startsWith('    '));
        expect(rows).toHaveLength(value.levels.length);
        for (const [i, one] of value.levels.entries()) {
          const { line, column, pointer } = read.locate(['levels', i]);
          expect(pointer).toBe(`/levels/${i}`);
          expect(text.split('\n')[line - 1].slice(column - 1, column)).toBe(typeof plain(one) === 'string' ? '"' : '{');
        }
      }),
    );
  });

  test('is valid exactly if the schema says so', () => {
    const loose = fc.record(
      {
        $schema: fc.oneof(fc.string(), fc.integer()),
        version: fc.oneof({ weight: 5, arbitrary: fc.constant(1) }, fc.jsonValue()),
        name: fc.oneof({ weight: 5, arbitrary: name }, fc.string({ unit: 'binary', maxLength: 130 }), fc.jsonValue()),
        levels: fc.oneof(
          { weight: 5, arbitrary: fc.array(fc.oneof({ weight: 4, arbitrary: entry }, fc.jsonValue()), { maxLength: 4 }) },
          fc.jsonValue(),
        ),
        level: fc.string(),
      },
      { requiredKeys: [] },
    );
    const looseEntry = fc.record(
      {
        level: fc.oneof(fc.string(), fc.jsonValue()),
        introduces: fc.oneof(fc.array(fc.string()), fc.jsonValue()),
        chapter: fc.oneof(fc.string({ unit: 'binary' }), fc.jsonValue()),
        levl: fc.string(),
      },
      { requiredKeys: [] },
    );
    const ofEntries = fc.array(looseEntry, { maxLength: 3 }).map((levels) => ({ version: 1, name: 'a', levels }));
    fc.assert(
      fc.property(fc.oneof(loose, ofEntries, pack), (value) => {
        const text = JSON.stringify(value);
        const isValid = packSchema.safeParse(withoutExtensions(JSON.parse(text))).success;
        expect(readPack(text).ok, text).toBe(isValid);
      }),
    );
  });

  test('of any text gives problems with a place, and never throws', () => {
    const damaged = fc
      .tuple(pack, fc.array(edit, { minLength: 1, maxLength: 3 }))
      .map(([value, edits]) => edits.reduce((text, one) => apply(text, one), formatPack(value)));
    fc.assert(
      fc.property(fc.oneof(damaged, fc.string({ unit: 'binary' }), fc.json()), (text) => {
        const read = readPack(text);
        if (read.ok) return;
        expect(read.problems.length).toBeGreaterThan(0);
        for (const { code, message, hint, line, column } of read.problems) {
          expect(message, code).not.toBe('');
          expect(hint, code).not.toBe('');
          if (code === 'more-problems' || code === 'not-a-level' || code === 'not-utf8') continue;
          expect(line).toBeGreaterThanOrEqual(1);
          expect(column).toBeGreaterThanOrEqual(1);
          expect(line).toBeLessThanOrEqual(text.split('\n').length);
        }
      }),
    );
    for (const bytes of [[0xff, 0xfe], [0x89, 0x50, 0x4e, 0x47], [0x7b, 0xc3, 0x28], []])
      expect(readPack(new Uint8Array(bytes)).ok).toBe(false);
  });

  test('has a JSON Schema, which is the committed file (updated by vitest -u)', async () => {
    await expect(formatPackJsonSchema()).toMatchFileSnapshot('../../schema/pack.schema.json');
  });

  test('lists each level once', () => {
    expect(levelsOfPack({ levels: ['b', { chapter: 'C' }, { level: 'a' }, 'b'] })).toEqual(['b', 'a']);
  });

  test.each([
    ['', '1:1 empty-file the file is empty'],
    ['[]', '1:1 wrong-type expected the order of a pack (an object in { }), found an empty list'],
    ['{ "version": 1, "levels": [] }', '1:1 missing-key the key "name" is missing'],
    ['{ "version": 1, "nmae": "a", "levels": [] }', '1:17 unknown-key unknown key "nmae": did you mean "name"?'],
    ['{ "version": 2, "name": "a", "levels": [] }', /^1:14 newer-version .*version 2/],
    ['{ "version": "1", "name": "a", "levels": [] }', '1:14 unsupported-version version: expected 1, found the text "1"'],
    ['{ "version": 1, "name": " ", "levels": [] }', '1:25 empty-text name: expected a name, found only blanks'],
    ['{ "version": 1, "name": "a", "levels": {} }', '1:40 wrong-type levels: expected a list in [ ], found an object'],
    ['{ "version": 1, "name": "a", "levels": [3] }', /^1:41 wrong-type entry 1: expected the id of a level/],
    [
      '{ "version": 1, "name": "a", "levels": [{ "levle": "b" }] }',
      '1:43 unknown-key entry 1: unknown key "levle": did you mean "level"?',
    ],
    ['{ "version": 1, "name": "a", "levels": [{ "level": "b", "introduces": [] }] }', /^1:71 empty-list entry 1, introduces/],
    [
      '{ "version": 1, "name": "a", "levels": [{ "chapter": "b", "introduces": ["c"] }] }',
      /^1:59 unknown-key entry 1: unknown key "introduces"/,
    ],
    ['{ "version": 1, "name": "a", "name": "b", "levels": [] }', /^1:30 duplicate-key/],
    ['{ "version": 1, "name": "a", "levels": ["b",] }', /^1:44 trailing-comma/],
  ])('%s', (text, expected) => {
    const problems = problemsOf(text);
    expect(problems).toHaveLength(1);
    if (typeof expected === 'string') expect(problems[0]).toBe(expected);
    else expect(problems[0]).toMatch(expected);
  });
});
