import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { fromPointer, toPointer } from '../../schema/basics/problem.ts';
import { createLocator, createPlaceFinder } from '../../schema/json/locate.ts';
import { readPlain, scanJson } from '../../schema/json/scan.ts';
import { decodeUtf8 } from '../../schema/json/utf8.ts';
import { expectDeep } from '../depth.ts';

/** Almost valid JSON: valid texts with some characters removed, inserted or replaced. */
const nearJson = fc
  .tuple(
    fc.oneof(
      fc.json(),
      fc.json().map((text) => JSON.stringify(JSON.parse(text), null, 2)),
    ),
    fc.array(fc.tuple(fc.nat(), fc.nat(2), fc.constantFrom(...'{}[]:,"\\/ \n\t0123456789-+.eEuntrfalse\u0001ü'), fc.boolean()), {
      maxLength: 3,
    }),
  )
  .map(([text, edits]) =>
    edits.reduce((t, [at, removed, put, puts]) => {
      const i = at % (t.length + 1);
      return t.slice(0, i) + (puts ? put : '') + t.slice(i + removed);
    }, text),
  );

function parses(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

/** Every value within a JSON value, with its path. */
function* valuesIn(value: unknown, path: (string | number)[] = []): Generator<[(string | number)[], unknown]> {
  yield [path, value];
  if (typeof value !== 'object' || value === null) return;
  for (const [key, inner] of Object.entries(value)) yield* valuesIn(inner, [...path, Array.isArray(value) ? Number(key) : key]);
}

describe('the scan of a JSON text', () => {
  test('fails exactly if JSON.parse fails', () => {
    let refused = 0;
    fc.assert(
      fc.property(nearJson, (text) => {
        const { failure } = scanJson(text);
        const isBeyond = failure?.what === 'too-deep' || failure?.what === 'too-large';
        if (!isBeyond) expect(failure === null).toBe(parses(text));
        if (failure === null) return;
        refused++;
        expect(failure.offset).toBeGreaterThanOrEqual(0);
        expect(failure.offset).toBeLessThanOrEqual(text.length);
      }),
      { numRuns: 1200 },
    );
    // otherwise the property would be trivial
    expectDeep(refused).toBeGreaterThan(200);
  });

  test('is left out only if it would tell nothing', () => {
    let plain = 0;
    const repeated = fc.array(fc.constantFrom('a', ':', 'b:c', 'x-y', '__proto__', '\\u003a')).map((keys) => {
      return `{${keys.map((key, i) => `"${key}":${i % 3 === 0 ? '1e999' : i % 3 === 1 ? '":"' : '[{}]'}`).join()}}`;
    });
    const deep = fc.nat({ max: 80 }).map((depth) => '['.repeat(depth) + ']'.repeat(depth));
    fc.assert(
      fc.property(fc.oneof({ arbitrary: nearJson, weight: 6 }, repeated, deep), (text) => {
        const read = readPlain(text);
        if (read === null) return;
        plain++;
        expect(scanJson(text)).toEqual({ failure: null, repeated: [], hasExtensions: false });
        expect(read[0]).toEqual(JSON.parse(text));
      }),
      { numRuns: 1200 },
    );
    expectDeep(plain).toBeGreaterThan(100);
  });

  test.each([
    '',
    ' ',
    '0',
    '-0',
    '1e5',
    '1E+5',
    '"\\ud800"',
    '[]',
    '{}',
    ' [ 1 , { } ] ',
    'true',
    'nul',
    '1 2',
    '-',
    '00',
    '[1]]',
    '"',
    '{"a"',
    '\u00a01',
    '\u2028',
  ])('agrees with JSON.parse about %j', (text) => {
    expect(scanJson(text).failure === null).toBe(parses(text));
  });

  test('finds every duplicate key of an object', () => {
    const key = fc.constantFrom('a', 'b', 'c', '__proto__', 'constructor', '', '\n');
    fc.assert(
      fc.property(fc.array(key), (names) => {
        const { failure, repeated } = scanJson(`[0,{${names.map((name) => `${JSON.stringify(name)}:{}`).join()}}]`);
        expect(failure).toBeNull();
        const again = names.filter((name, i) => names.indexOf(name) < i);
        expect(repeated.map(({ path }) => path)).toEqual(again.map((name) => [1, name]));
      }),
    );
  });

  test('accepts a depth of 64', () => {
    expect(scanJson('['.repeat(64) + ']'.repeat(64)).failure).toBeNull();
  });
});

describe('the place of a value', () => {
  test('is the beginning of its text', () => {
    fc.assert(
      fc.property(fc.jsonValue({ maxDepth: 4 }), fc.constantFrom(undefined, 1, '\t'), (value, space) => {
        const text = ` ${JSON.stringify(value, null, space)}`;
        const locator = createLocator(text);
        for (const [path, inner] of valuesIn(JSON.parse(text))) {
          const pointer = toPointer(path);
          expect(fromPointer(pointer)).toEqual(path.map(String));
          const token = typeof inner === 'object' && inner !== null ? (Array.isArray(inner) ? '[' : '{') : JSON.stringify(inner);
          expect(text.startsWith(token, locator.offsetOf(pointer, 'value'))).toBe(true);
          const last = path.at(-1);
          if (typeof last === 'string')
            expect(text.startsWith(JSON.stringify(last), locator.offsetOf(pointer, 'key'))).toBe(true);
        }
      }),
    );
  });

  test('is that of the nearest surrounding value if it is missing', () => {
    const locator = createLocator('{"a": {"b": 1}}');
    expect(locator.offsetOf('/a/c/d', 'value')).toBe(6);
    expect(locator.offsetOf('/a/b/d', 'value')).toBe(12);
    expect(locator.offsetOf('/z', 'value')).toBe(0);
  });

  test('is that of the last of two equal keys, whose value JSON.parse takes', () => {
    expect(createLocator('{"a":1,"a":2}').offsetOf('/a', 'value')).toBe(11);
  });

  test('line and column give the offset again', () => {
    const part = fc.constantFrom('a', '\n', '\r\n', 'ü', '\t', '🚀');
    fc.assert(
      fc.property(fc.array(part), fc.nat(), (parts, n) => {
        const text = parts.join('');
        const offset = n % (text.length + 1);
        const { line, column } = createPlaceFinder(text)(offset);
        const before = text.split('\n').slice(0, line - 1);
        expect(before.join('\n').length + (line > 1 ? 1 : 0) + column - 1).toBe(offset);
      }),
    );
  });
});

describe('UTF-8', () => {
  const strict = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });

  const byte = fc.oneof(
    fc.nat(255),
    // the first and last bytes that may begin or continue a sequence
    fc.constantFrom(0x00, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xc1, 0xc2, 0xdf, 0xe0, 0xed, 0xef, 0xf0, 0xf4, 0xf5),
  );

  test('is refused exactly if the decoder of the platform refuses it', () => {
    fc.assert(
      fc.property(fc.array(byte, { maxLength: 6 }), (list) => {
        const bytes = Uint8Array.from(list);
        let expected: string | null = null;
        try {
          expected = strict.decode(bytes);
        } catch {}
        const { text, bad } = decodeUtf8(bytes);
        expect(bad === null).toBe(expected !== null);
        if (expected !== null) expect(text).toBe(expected);
      }),
      { numRuns: 2000 },
    );
  });

  test('is refused exactly so for every pair of first bytes, with as many bytes after them as they need', () => {
    const disagreeing: number[][] = [];
    for (let first = 0x80; first < 0x100; first++) {
      for (let second = 0; second < 0x100; second++) {
        for (const after of [[], [0x80], [0xbf, 0x80]]) {
          const bytes = Uint8Array.from([first, second, ...after]);
          let isValid = true;
          try {
            strict.decode(bytes);
          } catch {
            isValid = false;
          }
          if ((decodeUtf8(bytes).bad === null) !== isValid) disagreeing.push([...bytes]);
        }
      }
    }
    expect(disagreeing).toEqual([]);
  });

  test('is decoded like the decoder of the platform does', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), fc.nat(20_000), (text, length) => {
        const long = text + 'a'.repeat(length) + text;
        const { text: read, bad } = decodeUtf8(new TextEncoder().encode(long));
        expect(bad).toBeNull();
        expect(read === long).toBe(true);
      }),
    );
  });

  test('the text before a bad byte is kept', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (before) => {
        const bytes = new TextEncoder().encode(before);
        const { text, bad } = decodeUtf8(Uint8Array.from([...bytes, 0xff, 0x61]));
        expect(bad).toEqual({ byte: 0xff, at: bytes.length, offset: before.length });
        expect(text).toBe(`${before}\ufffda`);
      }),
    );
  });
});
