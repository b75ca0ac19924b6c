import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { closestName, editDistance, quote } from '../../schema/basics/words.ts';
import { codeFrame, levelSchema } from '../../schema/index.ts';

/** The distance by definition, without a limit. */
function plainDistance(a: string, b: string): number {
  if (a === '' || b === '') return a.length + b.length;
  const [x, y] = [a.at(-1), b.at(-1)];
  const [p, q] = [a.slice(0, -1), b.slice(0, -1)];
  let least = Math.min(plainDistance(p, b) + 1, plainDistance(a, q) + 1, plainDistance(p, q) + (x === y ? 0 : 1));
  if (p.at(-1) === y && q.at(-1) === x && p !== '' && q !== '')
    least = Math.min(least, plainDistance(a.slice(0, -2), b.slice(0, -2)) + 1);
  return least;
}

const KEYS = Object.keys(levelSchema.shape);

describe('did you mean', () => {
  test('the distance is exact up to the limit, and beyond it is only known to be larger', () => {
    const word = fc.string({ unit: fc.constantFrom('a', 'b', 'c'), maxLength: 6 });
    fc.assert(
      fc.property(word, word, fc.nat(6), (a, b, limit) => {
        const distance = plainDistance(a, b);
        expect(editDistance(a, b, limit)).toBe(distance <= limit ? distance : limit + 1);
      }),
      { numRuns: 200 },
    );
  });

  test('a single typo in any key of the format is recognised', () => {
    fc.assert(
      fc.property(fc.constantFrom(...KEYS), fc.nat(), fc.constantFrom('drop', 'double', 'swap'), (key, n, slip) => {
        const i = n % (key.length - 1);
        const [a, b] = [key[i], key[i + 1]];
        const middle = slip === 'drop' ? b : slip === 'double' ? a + a + b : b + a;
        expect(closestName(key.slice(0, i) + middle + key.slice(i + 2), KEYS)).toBe(key);
      }),
    );
  });

  test.each([
    ['asteriods', 'asteroids'],
    ['Asteroids', 'asteroids'],
    ['blackhole', 'blackHole'],
    ['schema', '$schema'],
    ['runz', 'runs'],
    ['repulsers', 'repulsors'],
    ['gravity', null],
    ['z', null],
    ['', null],
  ])('%s: %s', (written, meant) => {
    expect(closestName(written, KEYS)).toBe(meant);
  });

  test('no one-letter key is guessed from another letter', () => {
    expect(closestName('z', ['x', 'y'])).toBeNull();
    expect(closestName('X', ['x', 'y'])).toBe('x');
  });

  test('one typo is allowed in a short name, and one for every three letters in a long one; the nearest and first match wins', () => {
    expect(closestName('v', ['vx', 'vy'])).toBe('vx');
    expect(closestName('xv', ['vx', 'vy'])).toBe('vx');
    expect(closestName('hto', ['hot'])).toBe('hot');
    expect(closestName('abcxyf', ['abcdef'])).toBe('abcdef');
    expect(closestName('abxyzf', ['abcdef'])).toBeNull();
    expect(closestName('abxye', ['abcde'])).toBeNull();
    expect(closestName('abcd', ['abxy', 'abce', 'abcf', 'xbcd'])).toBe('abce');
  });
});

describe('quoted text', () => {
  test('is short and contains no control characters', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        const quoted = quote(text);
        expect(quoted).not.toMatch(/[\p{Cc}\p{Cf}]/u);
        if (/^[a-z ]{0,40}$/.test(text)) expect(quoted).toBe(`"${text}"`);
      }),
    );
    expect(quote('a'.repeat(99))).toBe(`"${'a'.repeat(40)}…"`);
  });
});

describe('the code frame', () => {
  const text = 'one\ntwo\n\tthree: 3\nfour\r\nfive\nsix';

  test('shows two lines around, with a caret below the column', () => {
    expect(codeFrame(text, 3, 9)).toBe(
      ['  1 | one', '  2 | two', '> 3 |  three: 3', '    |         ^', '  4 | four', '  5 | five'].join('\n'),
    );
  });

  test('ends at the end of the text', () => {
    expect(codeFrame(text, 1, 1)).toBe(['> 1 | one', '    | ^', '  2 | two', '  3 |  three: 3'].join('\n'));
    expect(codeFrame(text, 6, 4)).toBe(['  4 | four', '  5 | five', '> 6 | six', '    |    ^'].join('\n'));
  });

  test('cuts long lines to the part around the column', () => {
    const frame = codeFrame(`${'a'.repeat(5000)}X${'b'.repeat(5000)}`, 1, 5001).split('\n');
    expect(frame[0].length).toBeLessThan(130);
    expect(frame[0][frame[1].indexOf('^')]).toBe('X');
  });

  test('shows 110 characters of a line, from its beginning if the place is among the first 90', () => {
    const lengths = fc.oneof(fc.integer({ min: 1, max: 300 }), fc.integer({ min: 108, max: 112 }));
    const letters = Array.from({ length: 1000 }, (_, i) => 'abcdefghij'[i % 10]).join('');
    fc.assert(
      fc.property(lengths, fc.integer({ min: 1, max: 300 }), (length, place) => {
        const text = letters.slice(0, length);
        const column = Math.min(place, length + 1);
        const [line, caret] = codeFrame(text, 1, column).split('\n');
        const from = column > 90 ? column - 55 : 0;
        const shown = text.slice(from, from + 110);
        const rest = length > from + 110 ? '…' : '';
        expect(line).toBe(`> 1 | ${from > 0 ? '…' : ''}${shown}${rest}`);
        expect(caret).toBe(`    | ${' '.repeat(column - 1 - from + (from > 0 ? 1 : 0))}^`);
      }),
      { numRuns: 200 },
    );
  });

  test('the caret is below the character, whatever comes before it', () => {
    const character = fc.constantFrom('a', '\t', 'ü', '🚀', '\u0007', '\u200b');
    fc.assert(
      fc.property(fc.array(character, { maxLength: 60 }), (before) => {
        const [line, caret] = codeFrame(`${before.join('')}X`, 1, before.join('').length + 1).split('\n');
        expect(Array.from(line)[caret.indexOf('^')]).toBe('X');
        expect(line).not.toMatch(/[\p{Cc}\p{Cf}]/u);
      }),
    );
  });
});
