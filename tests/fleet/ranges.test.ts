import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { rangesOf, readRanges } from '../../cli/fleet/index.ts';
import { Failure } from '../../cli/terminal/messages.ts';

const TOTAL = 60;
const numbers = fc.array(fc.nat({ max: TOTAL - 1 }), { maxLength: 2 * TOTAL });

describe('ranges', () => {
  it.each([
    [[], ''],
    [[0], '0'],
    [[7, 2, 5, 6, 5], '2,5-7'],
    [[4, 3], '3,4'],
    [[0, 1, 2, 10, 11, 12], '0-2,10-12'],
  ])('of %j are %j', (list, text) => expect(rangesOf(list)).toBe(text));

  it('are read as the numbers that they were made of', () => {
    fc.assert(
      fc.property(numbers, (list) => {
        fc.pre(list.length > 0);
        expect(readRanges(rangesOf(list), '--only', TOTAL)).toEqual([...new Set(list)].sort((a, b) => a - b));
      }),
    );
  });

  it('are as short as they can be: parts are apart, and no range could be two numbers', () => {
    fc.assert(
      fc.property(numbers, (list) => {
        const parts = rangesOf(list)
          .split(',')
          .filter(Boolean)
          .map((part) => part.split('-').map(Number));
        for (const [i, part] of parts.entries()) {
          if (part.length === 2) expect(part[1] - part[0]).toBeGreaterThanOrEqual(2);
          const next = parts[i + 1];
          if (next === undefined) continue;
          const gap = next[0] - part.at(-1)!;
          // two numbers in a row stay two numbers
          expect(gap).toBeGreaterThanOrEqual(part.length === 1 && next.length === 1 ? 1 : 2);
        }
      }),
    );
  });

  it('are read however they are written', () => {
    expect(readRanges('7,0-2,1,5-5', '--only', 8)).toEqual([0, 1, 2, 5, 7]);
  });

  it.each([
    '',
    ',',
    '1,',
    'a',
    '-1',
    '1-',
    '3-1',
    '1--2',
    '1-2-3',
    '1 ,2',
    '8',
    '0-8',
    '0-99999999999999999999',
    '1.5',
    '0x1',
    '1:3',
  ])('refuse %j', (text) => expect(() => readRanges(text, '--only', 8)).toThrow(Failure));
});
