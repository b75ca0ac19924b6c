import { InvalidArgumentError } from 'commander';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parseHolds } from '../../cli/runs/index.ts';

// holds in order that do not overlap; some touch
const holds = fc.array(fc.tuple(fc.nat(50), fc.integer({ min: 1, max: 50 })), { minLength: 1, maxLength: 20 }).map((gaps) => {
  let at = 0;
  return gaps.map(([wait, length]): [number, number] => {
    const press = at + wait;
    at = press + length;
    return [press, at];
  });
});

it('reads press-release pairs, with or without spaces', () => {
  fc.assert(
    fc.property(holds, fc.constantFrom(',', ', ', ' , '), (list, comma) => {
      expect(parseHolds(list.map(([press, release]) => `${press}-${release}`).join(comma))).toEqual(list);
    }),
  );
  expect(parseHolds('none')).toEqual([]);
});

it('reads a run as the text field of the editor shows it, and seconds', () => {
  expect(parseHolds('# slowly\n12-96, 130-188 # swing\n@300 # drifts\n310..320')).toEqual([
    [12, 96],
    [130, 188],
    [310, 320],
  ]);
  expect(parseHolds('0.2s-1.6s')).toEqual([[12, 96]]);
});

it('refuses anything else with a caret under a place in it, and never returns reversed or overlapping holds', () => {
  fc.assert(
    fc.property(fc.string({ unit: fc.constantFrom('0', '1', '9', '-', ',', ' ', '.', 'x', '\t'), maxLength: 12 }), (text) => {
      try {
        const list = parseHolds(text).flat();
        expect(list.length).toBeGreaterThan(0);
        for (let i = 1; i < list.length; i++) expect(list[i]).toBeGreaterThanOrEqual(list[i - 1] + (i % 2));
      } catch (error) {
        if (!(error instanceof InvalidArgumentError)) throw error;
        const [, shown, caret] = error.message.split('\n');
        expect(shown).toBe(`  ${text.replace(/\s/g, ' ')}`);
        expect(caret).toMatch(/^ {2,}\^ \S/);
        expect(caret.indexOf('^')).toBeLessThanOrEqual(2 + text.length);
      }
    }),
    { numRuns: 2000 },
  );
});

describe('reports what was expected, and where', () => {
  const WRONG: readonly [holds: string, caret: number, why: string][] = [
    ['96-12', 0, 'the release (12) must be later than the press (96)'],
    ['12-12', 0, 'the release (12) must be later'],
    ['12-96,90-188', 6, 'this hold begins at 90, before the previous one ends (96)'],
    ['-5-10', 0, 'expected the tick of a press here'],
    ['12-x', 3, 'expected the tick of a release here (a whole number from 0 to 216000), found "x"'],
    ['12', 2, 'expected "-" and the tick of the release after 12'],
    ['12-96;', 5, 'expected "," and another hold, or the end'],
    ['12-96,', 6, 'found the end'],
    ['1.5-3', 0, 'expected "-" or a whole number of ticks, found 1.5'],
    ['1-2.5s', 0, 'expected both in ticks or both in seconds, found 1 and 2.5s'],
    ['', 0, 'found the end'],
    ['# drifts', 8, 'found the end'],
    ['12-96 130-188', 6, 'expected "," and another hold, or the end'],
    ['0-99999999999999999999', 2, 'is later than 216000'],
  ];

  it.each(WRONG)('%s', (text, caret, why) => {
    expect(() => parseHolds(text)).toThrow(InvalidArgumentError);
    expect(() => parseHolds(text)).toThrow(`like 12-96,130-188; or none\n  ${text}\n  ${' '.repeat(caret)}^ `);
    expect(() => parseHolds(text)).toThrow(why);
  });
});

it('shows only the part around the place if the value is very long', () => {
  const text = `${Array.from({ length: 5000 }, (_, i) => `${2 * i}-${2 * i + 1}`).join(',')};`;
  expect(() => parseHolds(text)).toThrow(/\^ expected "," and another hold, or the end, found ";"$/);
  try {
    parseHolds(text);
  } catch (error) {
    expect((error as Error).message.length).toBeLessThan(500);
  }
});
