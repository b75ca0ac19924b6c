import process from 'node:process';
import fc from 'fast-check';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { alignColumns } from '../../cli/report-parts/index.ts';
import { checkPretty } from '../../cli/reporters/pretty.ts';
import { createStatusLine, widthOf } from '../../cli/terminal/terminal.ts';
import { brokenLevel, CONTEXT, checkedLevel, resultsOf } from './reporters/context.ts';

afterEach(() => {
  vi.unstubAllEnvs();
  vi.restoreAllMocks();
});

describe('a table', () => {
  const HEAD = ['grade', 'word', 'level'];
  const ROWS = [
    ['1.0', 'gentle', 'levels/a.level.json'],
    ['10.0', '', 'b'],
  ];

  it('is aligned where it fits, and where a line can be as long as it likes', () => {
    const wide = ['grade  word    level', '  1.0  gentle  levels/a.level.json', ' 10.0          b'];
    for (const width of [null, 34, 80]) expect(alignColumns(ROWS, { head: HEAD, right: [0], lead: 2, width })).toEqual(wide);
  });

  it('has the titles beside its cells on a narrow terminal', () => {
    expect(alignColumns(ROWS, { head: HEAD, right: [0], lead: 2, width: 33 })).toEqual([
      '',
      'levels/a.level.json  grade 1.0\n    word gentle',
      'b  grade 10.0',
    ]);
  });

  it('has no line longer than the terminal, unless a word is, and loses no word', () => {
    const cell = fc.array(fc.stringMatching(/^[a-z0-9é]{1,9}$/), { maxLength: 6 }).map((words) => words.join(' '));
    fc.assert(
      fc.property(
        fc.array(fc.array(cell, { minLength: 1, maxLength: 5 }), { maxLength: 6 }),
        fc.integer({ min: 13, max: 60 }),
        (rows, width) => {
          const texts = alignColumns(rows, { width });
          expect(texts).toHaveLength(rows.length);
          for (const line of texts.join('\n').split('\n')) expect(line.length).toBeLessThanOrEqual(width);
          const words = (text: string) => text.split(/\s+/).filter(Boolean);
          expect(texts.map(words)).toEqual(rows.map((row) => words(row.join(' '))));
        },
      ),
    );
  });

  it('of a check begins each row with the verdict', () => {
    const results = resultsOf([checkedLevel({ file: 'levels/a-long-name.level.json' }), brokenLevel({ problems: [] })]);
    const lines = checkPretty(results, { ...CONTEXT, width: 40 }).split('\n');
    expect(lines.slice(0, 4)).toEqual([
      'completable',
      '    levels/a-long-name.level.json  A',
      '    2.00 s  no minerals  nothing deadly',
      'broken  levels/a.level.json  A',
    ]);
    expect(checkPretty(results, CONTEXT).split('\n')[0]).toBe(
      'completable  levels/a-long-name.level.json  A  2.00 s  no minerals  nothing deadly',
    );
  });
});

describe('the width of lines', () => {
  it('is that of the terminal, or COLUMNS; files and pipes have none', () => {
    vi.stubEnv('COLUMNS', '');
    expect(widthOf({ isTTY: true, columns: 40 })).toBe(40);
    expect(widthOf({ isTTY: true })).toBeNull();
    expect(widthOf({ isTTY: true, columns: 0 })).toBeNull();
    vi.stubEnv('COLUMNS', '50');
    expect(widthOf({ isTTY: true, columns: 40 })).toBe(50);
    expect(widthOf({ columns: 40 })).toBeNull();
    for (const junk of ['x', '-1', '0', '1.5']) {
      vi.stubEnv('COLUMNS', junk);
      expect(widthOf({ isTTY: true, columns: 40 })).toBe(40);
    }
  });
});

describe('the status line', () => {
  it.each([
    ['xterm', true],
    ['dumb', false],
  ])('on a terminal of type %s is shown: %s', (term, isShown) => {
    const before = process.stderr.isTTY;
    const written: string[] = [];
    vi.spyOn(process.stderr, 'write').mockImplementation((text) => written.push(String(text)) > 0);
    vi.stubEnv('TERM', term);
    try {
      process.stderr.isTTY = true;
      let now = 0;
      vi.spyOn(performance, 'now').mockImplementation(() => now);
      const line = createStatusLine();
      now = 10_000;
      line.show('half done');
      line.clear();
    } finally {
      process.stderr.isTTY = before;
    }
    expect(written.join('')).toBe(isShown ? '\r\u001b[2Khalf done\r\u001b[2K' : '');
  });
});
