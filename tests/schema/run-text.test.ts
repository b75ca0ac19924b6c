import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { joinHolds } from '../../engine/index.ts';
import { formatRunText, type Hold, LIMITS, NOTE_TEXT, notesInOrder, type RunNote, readRunText } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';

const read = (text: string) => {
  const reading = readRunText(text);
  if (!reading.ok) throw new Error(`${reading.line}:${reading.column} ${reading.message}`);
  return reading;
};

/** Holds that are sorted and neither overlap nor touch, as a document has them. */
const holds: fc.Arbitrary<Hold[]> = fc
  .array(fc.tuple(fc.integer({ min: 1, max: 40 }), fc.integer({ min: 1, max: 40 })), { maxLength: 8 })
  .chain((gaps) =>
    fc.nat(1).map((first) => {
      let at = -first;
      return gaps.map(([wait, length]): Hold => {
        const press = at + wait;
        at = press + length;
        return [press, at];
      });
    }),
  );

const text = fc
  .oneof(
    fc.string({ minLength: 1, maxLength: 30 }),
    fc.string({ minLength: 1, maxLength: 20, unit: 'binary' }),
    fc.constantFrom('# #', '@5 # x', '60-90', 'none', ','),
  )
  .map((one) => one.replace(/[\n\r\v\f\u0085\u2028\u2029]/g, ' ').trim())
  .filter((one) => NOTE_TEXT.test(one));

const notes = fc.array(fc.record({ tick: fc.oneof(fc.nat(200), fc.constantFrom(0, LIMITS.tick)), text }), { maxLength: 6 });

/** Notes, many of which are at a press or release. */
const script = fc.tuple(holds, notes, fc.array(fc.nat(30), { maxLength: 6 })).map(([list, own, picks]) => {
  const edges = list.flat();
  const moved = own.map((note, i): RunNote => {
    const edge = edges[(picks[i] ?? 0) % Math.max(1, edges.length)];
    return i % 3 === 0 || edge === undefined ? note : { ...note, tick: edge };
  });
  return { holds: list, notes: notesInOrder(moved) };
});

describe('a run as text', () => {
  it('reads the same holds and notes from what it writes', () => {
    fc.assert(
      fc.property(script, (run) => {
        const again = read(formatRunText(run));
        expect(again.holds).toEqual(run.holds);
        expect(again.notes).toEqual(run.notes);
        expect(again.remarks).toEqual([]);
      }),
      { numRuns: 1000 },
    );
  });

  it('is stable once it is canonical', () => {
    const piece = fc.constantFrom(
      '60-150',
      '200..410',
      '1.0s-2.5s',
      ',',
      '\n',
      '# a',
      '#',
      '@7 # b',
      ' ',
      '5 - 9',
      '300–301',
      '\t',
    );
    let read_ = 0;
    fc.assert(
      fc.property(fc.array(piece, { maxLength: 12 }), (pieces) => {
        const first = readRunText(pieces.join(''));
        if (!first.ok) return;
        read_++;
        const once = formatRunText({ ...first, holds: joinHolds(first.holds) });
        const second = read(once);
        expect(second.notes).toEqual(first.notes);
        expect(second.holds).toEqual(joinHolds(first.holds));
        expect(formatRunText(second)).toBe(once);
      }),
      { numRuns: 2000 },
    );
    // the pieces fit together often enough for this to say something
    expectDeep(read_).toBeGreaterThan(200);
  });

  it('writes a note where its hold is, on a line of its own, or with its tick', () => {
    const run = {
      holds: [
        [60, 150],
        [200, 410],
        [500, 510],
      ] as Hold[],
      notes: [
        { tick: 0, text: 'wait' },
        { tick: 100, text: 'in the middle' },
        { tick: 150, text: 'lets go' },
        { tick: 200, text: 'first swing' },
        { tick: 200, text: 'and again' },
        { tick: 900, text: 'far' },
      ],
    };
    expect(formatRunText(run)).toBe(
      [
        '# wait',
        '60-150',
        '@100 # in the middle',
        '# lets go',
        '200-410 # first swing',
        '@200 # and again',
        '500-510',
        '@900 # far',
      ].join('\n'),
    );
    expect(
      formatRunText({
        holds: [
          [1, 2],
          [4, 5],
        ],
        notes: [{ tick: 4, text: 'x' }],
      }),
    ).toBe('1-2, 4-5 # x');
    expect(formatRunText({ holds: [], notes: [] })).toBe('none');
    expect(formatRunText({ holds: [], notes: [{ tick: 3, text: 'x' }] })).toBe('@3 # x');
  });

  it.each([
    [
      '60-150, 200-410 # first swing',
      [
        [60, 150],
        [200, 410],
      ],
      [[200, 'first swing']],
    ],
    [
      '60 - 150\n200..410',
      [
        [60, 150],
        [200, 410],
      ],
      [],
    ],
    [
      '60–150,\n\n200—410,',
      [
        [60, 150],
        [200, 410],
      ],
      [],
    ],
    [
      '60-150 200-410',
      [
        [60, 150],
        [200, 410],
      ],
      [],
    ],
    [
      '1.0s-2.5s, 3 s … 4 S',
      [
        [60, 150],
        [180, 240],
      ],
      [],
    ],
    ['0.1s-0.2s', [[6, 12]], []],
    ['none', [], []],
    ['', [], []],
    [' NONE # drifts', [], [[0, 'drifts']]],
    [
      '# a\n5-9\n# b\r\n@7 # c\n@0.5s#d',
      [[5, 9]],
      [
        [0, 'a'],
        [7, 'c'],
        [9, 'b'],
        [30, 'd'],
      ],
    ],
    ['5-9 @7 # c', [[5, 9]], [[7, 'c']]],
    ['5-9 #\n#  ', [[5, 9]], []],
    [
      '1-2\u20283-4\u00855-6',
      [
        [1, 2],
        [3, 4],
        [5, 6],
      ],
      [],
    ],
  ] as [string, Hold[], [number, string][]][])('reads %j', (source, expected, noted) => {
    const reading = read(source);
    expect(reading.holds).toEqual(expected);
    expect(reading.notes).toEqual(noted.map(([tick, words]) => ({ tick, text: words })));
    expect(reading.remarks).toEqual([]);
  });

  it('says what becomes of holds that overlap, touch or are out of order, and of rounded times', () => {
    const said = (source: string) => read(source).remarks.map(({ line, column, message }) => `${line}:${column} ${message}`);
    expect(said('60-150, 100-200')).toEqual(['1:9 60-150 and 100-200 overlap or touch, and become 60-200']);
    expect(said('60-150\n10-20')).toEqual(['2:1 the holds are put in order of time']);
    expect(said('10-20, 20-30, 5-11')).toEqual([
      '1:15 the holds are put in order of time',
      '1:15 3 holds overlap or touch, and become 5-30',
    ]);
    expect(said('1.01s-2s')).toEqual(['1:1 1.01s is rounded to tick 61']);
  });

  it('says truly what becomes of holds', () => {
    const any = fc.array(fc.tuple(fc.nat(60), fc.integer({ min: 1, max: 20 })), { maxLength: 6 });
    fc.assert(
      fc.property(any, (list) => {
        const raw = list.map(([press, length]): Hold => [press, press + length]);
        const { remarks } = read(raw.map((hold) => hold.join('-')).join(','));
        const joined = joinHolds(raw);
        const isSorted = raw.every(([press], i) => i === 0 || press >= raw[i - 1][0]);
        expect(remarks.some(({ message }) => message.includes('order of time'))).toBe(!isSorted);
        const becoming = remarks.flatMap(({ message }) => /become (\d+)-(\d+)$/.exec(message)?.slice(1).map(Number) ?? []);
        expect(joined.flat()).toEqual(expect.arrayContaining(becoming));
        expect(becoming.length > 0).toBe(joined.length < raw.length);
      }),
      { numRuns: 500 },
    );
  });

  it.each([
    ['60-', '1:4', 'expected the tick of a release here', 'found the end'],
    ['60-\n150', '1:4', 'expected the tick of a release here', 'found the end of the line'],
    ['60', '1:3', 'expected "-" and the tick of the release after 60', 'found the end'],
    ['60-150; 3-4', '1:7', 'expected "," and another hold, or the end', 'found ";"'],
    ['60-150,,3-4', '1:8', 'expected the tick of a press', 'found ","'],
    ['1-2\n-5-10', '2:1', 'expected the tick of a press', 'found "-"'],
    ['NaN-5', '1:1', 'expected the tick of a press', 'found "NaN"'],
    ['1e3-5', '1:2', 'expected "-"', 'found "e3"'],
    ['__proto__', '1:1', 'expected the tick of a press', 'found "__proto__"'],
    ['150-60', '1:1', 'the release (60) must be later than the press (150)', ''],
    ['60-60', '1:1', 'must be later', ''],
    ['0-216001', '1:3', 'tick 216001 is later than 216000', ''],
    [`0-${'9'.repeat(400)}`, '1:3', 'tick 99999999999999999999… is later than 216000', ''],
    ['0s-3601s', '1:4', 'tick 3601s is later than 3600s', ''],
    ['1.5-3', '1:1', 'expected "-" or a whole number of ticks', 'found 1.5'],
    ['1s-150', '1:1', 'expected both in ticks or both in seconds', 'found 1s and 150'],
    ['none, 3-4', '1:5', 'expected nothing after none', 'found ","'],
    ['3-4, none', '1:6', 'expected the tick of a press', 'found "none"'],
    ['@200', '1:5', 'expected # and the text of the note after @200', 'found the end'],
    ['@x # a', '1:2', 'expected the tick of a note', 'found "x"'],
    ['3-4 🚀', '1:5', 'expected ","', 'found "🚀"'],
    [`3-4 # ${'a'.repeat(201)}`, '1:5', 'expected a note of at most 200 characters', 'found 201'],
  ])('of %j says where and what', (source, place, expected, found) => {
    const reading = readRunText(source);
    if (reading.ok) throw new Error('was read');
    expect(`${reading.line}:${reading.column}`).toBe(place);
    expect(reading.message).toContain(expected);
    expect(reading.message).toContain(found);
    expect(reading.hint).toMatch(/^[A-Z].*\.$/);
  });

  it('never throws, and always says a place in the text', () => {
    const letters = fc.string({
      maxLength: 40,
      unit: fc.constantFrom(...'0123456789-.,# @sS\n\r\t\u2028\u00a0–…nonex[]{}"\ud800'),
    });
    fc.assert(
      fc.property(fc.oneof(letters, fc.string({ unit: 'binary', maxLength: 60 })), fc.boolean(), (source, isStrict) => {
        const reading = readRunText(source, { isStrict });
        if (reading.ok) {
          expect(reading.holds.every(([press, release]) => press >= 0 && release > press && release <= LIMITS.tick)).toBe(true);
          expect(reading.holds.flat().every(Number.isInteger)).toBe(true);
          expect(reading.notes.every((note) => NOTE_TEXT.test(note.text) && note.text.length <= LIMITS.note)).toBe(true);
          return;
        }
        const { offset, line, column } = reading;
        expect(offset).toBeGreaterThanOrEqual(0);
        expect(offset).toBeLessThanOrEqual(source.length);
        const lines = source.split(/\r\n|[\n\r\v\f\u0085\u2028\u2029]/);
        expect(line).toBeLessThanOrEqual(lines.length);
        expect(column).toBeLessThanOrEqual(lines[line - 1].length + 1);
        expect(reading.message.length).toBeLessThan(200);
      }),
      { numRuns: 5000 },
    );
  });

  it('stops at limits, also in huge texts', () => {
    const many = (count: number) => Array.from({ length: count }, (_, i) => `${3 * i}-${3 * i + 1}`).join(',');
    expect(read(many(LIMITS.holds)).holds).toHaveLength(LIMITS.holds);
    expect(readRunText(many(LIMITS.holds + 1))).toMatchObject({
      ok: false,
      message: expect.stringContaining('at most 20000 holds'),
    });
    const noted = (count: number) => Array.from({ length: count }, (_, i) => `# ${i}\n`).join('');
    expect(read(noted(LIMITS.notes)).notes).toHaveLength(LIMITS.notes);
    expect(readRunText(noted(LIMITS.notes + 1))).toMatchObject({ ok: false, line: LIMITS.notes + 1 });
    expect(readRunText('9'.repeat(1e6)).ok).toBe(false);
    expect(readRunText(`5-9${' '.repeat(1e6)}x`)).toMatchObject({ ok: false, column: 1e6 + 4 });
    expect(readRunText('#'.repeat(1e6)).ok).toBe(false);
  });
});
