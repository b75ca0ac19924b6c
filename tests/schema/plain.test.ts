import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readLevel as readPlainLevel } from '../../game/index.ts';
import {
  formatLevel,
  formatLevelShape,
  LIMITS,
  levelSchema,
  MAX_FILE_SIZE,
  type OwnRules,
  readLevel,
} from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { BASE, broken } from './base-level.ts';
import { apply, edit } from './edits.ts';
import { BAD_LEVELS } from './fixtures/bad-levels.ts';

/** Reads a file with both readers, which must agree. */
function both(source: string | Uint8Array, rules?: OwnRules): boolean {
  const full = readLevel(source, { rules });
  const plain = readPlainLevel(source, { rules });
  if (full.ok) {
    expect(plain).toStrictEqual({ ok: true, level: full.level });
    // drawing and reports list objects in the order of keys
    if (plain.ok) expect(JSON.stringify(plain.level)).toBe(JSON.stringify(full.level));
    return true;
  }
  expect(plain).toEqual({ ok: false, message: expect.any(String), pointer: expect.any(String) });
  if (!plain.ok) {
    expect(plain.message).toMatch(/expected .*, found /s);
    expect(plain.message).not.toMatch(/undefined|\[object/);
    expect(plain.message.length).toBeLessThan(1200);
  }
  return false;
}

const textsIn = (folder: string): [name: string, text: Uint8Array][] => {
  const path = fileURLToPath(new URL(folder, import.meta.url));
  const names = readdirSync(path).filter((name) => name.endsWith('.json'));
  return names.map((name) => [name, new Uint8Array(readFileSync(join(path, name)))]);
};

const LEVELS = [...textsIn('../../levels'), ...textsIn('../cli/fixtures/levels')];

describe('the reader for games and that of the schema agree', () => {
  test('the shape as the text of a module is that of both', async () => {
    const source = Buffer.from(formatLevelShape()).toString('base64');
    const { LEVEL_SHAPE } = await import(/* @vite-ignore */ `data:text/javascript;base64,${source}`);
    expect(LEVEL_SHAPE.keys.name).toEqual({ type: 'string', least: 1, most: 120 });
    expect(Object.keys(LEVEL_SHAPE.keys)).toEqual(Object.keys(levelSchema.shape));
  });

  test.each(LEVELS)('about %s', (_, bytes) => {
    const text = new TextDecoder().decode(bytes);
    expect(both(text)).toBe(both(bytes));
  });

  test.each(BAD_LEVELS.map(({ name, source }) => [name, source] as const))('about %s', (_, source) => {
    expect(both(source)).toBe(false);
  });

  const deep = (depth: number) => `${'['.repeat(depth)}${']'.repeat(depth)}`;
  test.each([
    ['as deep as may be', broken('"range"', `"x-a": ${deep(63)}, "range"`), true],
    ['one deeper', broken('"range"', `"x-a": ${deep(64)}, "range"`), false],
    ['a million deep', deep(1_000_000), false],
    ['the key __proto__', broken('"range"', '"__proto__": [null, {"id": 1}], "range"'), false],
    ['the key __proto__ in an object', broken('"radius": 18', '"radius": 18, "__proto__": {"x": 2}'), false],
    ['the key __proto__ in allow', broken('"range"', '"allow": { "__proto__": 1 }, "range"'), false],
    ['the key __proto__ in an extension', broken('"range"', '"x-a": { "__proto__": 1 }, "range"'), true],
    ['the key constructor', broken('"range"', '"constructor": 1, "range"'), false],
    ['the key twice, once escaped', broken('"range"', '"r\\u0061nge": 3, "range"'), false],
    ['an x- key twice', broken('"range"', '"x-a": 3, "x-a": 3, "range"'), false],
    ['x- keys everywhere', broken('"hot": true', '"hot": true, "x-": [{"x-b": null}]'), true],
    ['an x- key in rules and allow', broken('"range"', '"rules": {"x-a": 1, "pull": 40}, "allow": {"x-a": 1}, "range"'), true],
    ['a mark as text', `\ufeff${BASE}`, false],
    ['a mark as bytes', new TextEncoder().encode(`\ufeff${BASE}`), false],
    ['a reversed hold', broken('[12, 96]', '[96, 12]'), false],
    ['an empty hold', broken('[12, 96]', '[12, 12]'), false],
    ['a hold of three', broken('[12, 96]', '[12, 96, 97]'), false],
    ['a tick that is not whole', broken('[12, 96]', '[12.5, 96]'), false],
    ['the last tick', broken('[130, 188]', `[130, ${LIMITS.tick}]`), true],
    ['beyond the last tick', broken('[130, 188]', `[130, ${LIMITS.tick + 1}]`), false],
    ['-0', broken('[12, 96]', '[-0, 96]').replace('712', '-0').replace('715', '-0.0'), true],
    ['a rule of -0', broken('"range"', '"rules": {"recoil": -0}, "range"'), true],
    ['the game’s own rules', broken('"range"', '"rules": {"pull": 39, "push": 20}, "range"'), true],
    ['an id twice', broken('"aa11"', '"k3x9qa"'), false],
    ['an id in capitals', broken('"aa11"', '"AA11"'), false],
    ['a number as id', broken('"aa11"', '11'), false],
    ['a conflict', broken('"range"', '"conflicts": [{"what": "a", "key": "b", "ours": {"any": [1]}}], "range"'), true],
    ['a conflict without a key', broken('"range"', '"conflicts": [{"what": "a"}], "range"'), false],
    ['a problem that is allowed', broken('"range"', '"allow": {"overlapping": "so it is"}, "range"'), true],
    ['no reason', broken('"range"', '"allow": {"overlapping": " "}, "range"'), false],
    ['an unknown code', broken('"range"', '"allow": {"overlaping": "a"}, "range"'), false],
    ['version 0', broken('"version": 1', '"version": 0'), false],
    ['version 2', broken('"version": 1', '"version": 2'), false],
    ['version 1.0', broken('"version": 1', '"version": 1.0'), true],
    ['version -1', broken('"version": 1', '"version": -1'), false],
    ['version "1"', broken('"version": 1', '"version": "1"'), false],
    ['no version', broken('"version": 1,', ''), false],
    ['a level that is null', 'null', false],
    ['NaN', broken('712', 'NaN'), false],
    ['a number beyond doubles', broken('712', '1e309'), false],
    ['a name of a lone surrogate', broken('"Base"', '"\\ud800"'), true],
    ['a name of blanks', broken('"Base"', '"  "'), true],
    ['too many objects', broken('"novae": [', `"novae": [${'{"x":1,"y":2,"radius":3},'.repeat(LIMITS.objects)}`), false],
  ])('about %s', (_, source, isValid) => {
    expect(both(source)).toBe(isValid);
  });

  test('about a file of 8 MiB, and one byte more', () => {
    const padded = (length: number) => BASE + ' '.repeat(length - BASE.length);
    expect(both(padded(MAX_FILE_SIZE))).toBe(true);
    expect(both(padded(MAX_FILE_SIZE + 1))).toBe(false);
    expect(both(new TextEncoder().encode(padded(MAX_FILE_SIZE + 1)))).toBe(false);
  });

  test('about the names of two runs', () => {
    const run = (name: string) => `{ "name": "${name}", "holds": [] }`;
    expect(both(broken('"runs": [', `"runs": [${run('first')},`))).toBe(false);
    expect(both(broken('"runs": [', `"runs": [${run('second')},`))).toBe(true);
  });

  test('about the rules of a folder', () => {
    for (const rules of [{ pull: 50 }, { pull: 39 }, { pull: 41, push: 1 }]) {
      expect(both(BASE, rules)).toBe(true);
      expect(both(broken('"range"', '"rules": {"pull": 41, "recoil": 1}, "range"'), rules)).toBe(true);
    }
    const own = readPlainLevel(broken('"range"', '"rules": {"pull": 41}, "range"'), { rules: { pull: 50, push: 5 } });
    expect(own).toMatchObject({ ok: true, level: { rules: { pull: 41, push: 5 } } });
  });

  test('about any valid file', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        expect(both(formatLevel(file))).toBe(true);
        expect(both(JSON.stringify(file))).toBe(true);
      }),
      { numRuns: 100 },
    );
  });

  // 10,000 files in `npm run bench -- soak`, and with PROPERTY_RUNS=10
  test('about mutated files', () => {
    const seen = { valid: 0, invalid: 0 };
    const text = fc.oneof(
      fc.constant(BASE),
      fc.constantFrom(...LEVELS.map(([, b]) => new TextDecoder().decode(b))),
      arbitraryFile.map(formatLevel),
    );
    fc.assert(
      fc.property(text, fc.array(edit, { minLength: 1, maxLength: 3 }), fc.boolean(), (original, edits, asBytes) => {
        const source = edits.reduce(apply, original);
        if (both(asBytes ? new TextEncoder().encode(source) : source)) seen.valid++;
        else seen.invalid++;
      }),
      { numRuns: 1000 },
    );
    expectDeep(seen.valid).toBeGreaterThan(10);
    expectDeep(seen.invalid).toBeGreaterThan(200);
  });

  test('about mutated bytes', () => {
    const bytes = new TextEncoder().encode(broken('"Base"', '"Bäse 🌌"'));
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.nat(bytes.length - 1), fc.nat(255)), { minLength: 1, maxLength: 4 }), (changes) => {
        const source = bytes.slice();
        for (const [at, byte] of changes) source[at] = byte;
        both(source);
      }),
      { numRuns: 500 },
    );
  });

  const REPLACEMENTS = [null, true, '', 'a', 0, -1, 0.5, 1e7, [], [1], {}, { x: 1 }, '1'.repeat(130)];
  test('about every value of a level, replaced by values of other types', () => {
    const whole = JSON.parse(broken('"range"', '"rules": {"pull": 41}, "allow": {"overlapping": "a"}, "recoil": true, "range"'));
    const replace = (value: unknown): unknown[] => {
      const others: unknown[] = [...REPLACEMENTS];
      if (Array.isArray(value)) {
        value.forEach((entry, i) => {
          others.push(...replace(entry).map((other) => value.with(i, other)), [...value, entry]);
        });
      } else if (typeof value === 'object' && value !== null) {
        for (const [key, entry] of Object.entries(value)) {
          const { [key]: _, ...rest } = value as Record<string, unknown>;
          others.push(rest, { ...rest, [`${key}s`]: entry }, ...replace(entry).map((other) => ({ ...value, [key]: other })));
        }
      }
      return others;
    };
    const all = replace(whole);
    expect(all.length).toBeGreaterThan(500);
    const valid = all.filter((file) => both(JSON.stringify(file)));
    expect(valid.length).toBeGreaterThan(50);
  });
});

describe('the message of the reader for games', () => {
  test.each([
    [
      '/blackHole/radius: expected a number of at least 0.001, found 0',
      '/blackHole/radius',
      broken('"radius": 18', '"radius": 0'),
    ],
    ['/astronaut/x: expected a number, found "712"', '/astronaut/x', broken('712', '"712"')],
    ['/astronaut: expected the key "x", found none of this name', '/astronaut', broken('"x": 712, ', '')],
    ['/runs/0/holds/1/0: expected a whole number, found 130.5', '/runs/0/holds/1/0', broken('130', '130.5')],
    [
      '/version: expected a version up to 1, found 2: update gravity-quest-toolkit',
      '/version',
      broken('"version": 1', '"version": 2'),
    ],
    ['/novae/0/id: expected a text that matches ^[a-z0-9]{2,16}$, found "A"', '/novae/0/id', broken('aa11', 'A')],
    [
      'line 4, column 24: expected a key in double quotes, found "}"',
      '/astronaut',
      '{\n"version":1,\n"name":"a",\n"astronaut": { "x": 7, }}',
    ],
    ['expected at most 8 MiB, found more', '', ' '.repeat(MAX_FILE_SIZE + 1)],
    ['expected UTF-8, found the byte ff at offset 1', '', Uint8Array.of(0x7b, 0xff)],
    ['line 1, column 1: expected a value, found the end', '', ''],
    ['line 1, column 5: expected the closing " of a text, found the end', '', '{"a\\'],
  ])('is %s', (message, pointer, source) => {
    expect(readPlainLevel(source)).toEqual({ ok: false, message, pointer });
  });

  test.each([[undefined], [null], [{}], [[]], [1]])('says what was given instead of a text: %j', (source) => {
    expect(readPlainLevel(source as never)).toMatchObject({
      ok: false,
      message: expect.stringMatching(/^expected the text or the bytes/),
    });
  });
});
