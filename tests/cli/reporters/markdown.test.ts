import { appendFileSync, chmodSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import {
  COMMENT_BYTES,
  checkMarkdown,
  markdownBlock,
  markdownCode,
  markdownText,
  markdownWithin,
  stepSummary,
} from '../../../cli/reporters/markdown.ts';
import { itQuick } from '../../depth.ts';
import { fallThrough, gq, makeFiles } from '../gq.ts';
import { brokenLevel, CONTEXT, checkedLevel, resultsOf, shownProblem } from './context.ts';

const MIB = 1024 * 1024;
const files = makeFiles({ 'levels/a.level.json': fallThrough(), 'levels/b.level.json': fallThrough({ runs: [] }) });
afterAll(() => files.remove());
const cwd = files.directory;
const at = (name: string): string => join(cwd, name);

const hostile = fc.string({
  unit: fc.constantFrom(
    '|',
    '`',
    '``',
    '\\',
    '<b>',
    '&amp;',
    '\n',
    '\r\n',
    '*',
    '_',
    '@me',
    '#12',
    'http://x',
    ' ',
    'a',
    '\ud800',
    '~',
    '# ',
  ),
});
const rowsOf = (text: string): string[] => text.split('\n').filter((line) => line.startsWith('| '));

describe('the markdown reporter', () => {
  it('shows failing levels first, each with its problems and the way to see them', () => {
    const levels = [checkedLevel(), brokenLevel({ file: 'levels/b.level.json', name: 'B' })];
    const text = checkMarkdown(resultsOf(levels), CONTEXT);
    expect(text).toContain('### ❌ 1 of 2 levels fails');
    const rows = rowsOf(text);
    expect(rows[2]).toBe('| ❌ broken | `levels/b.level.json` | B | unknown key "asteriods" |');
    expect(rows.at(-1)).toBe('| completable | `levels/a.level.json` | A | 2.00 s, no minerals, nothing deadly |');
    expect(text).toContain(
      '- **error** `run-does-not-complete` in line 9, column 5: unknown key "asteriods"  \n  Write "asteroids".\n',
    );
    expect(text).toContain('Look at it: `gq edit --open levels/b.level.json:120`');
    expect(text).not.toContain('Left out');
    const early = checkMarkdown(resultsOf([], { unchecked: ['x.level.json'], interrupted: true }), CONTEXT);
    expect(early).toContain('**A signal ended the check early**: 1 level not checked\n\n- `x.level.json`\n');
  });

  it('has a row for each level, whatever is in names and messages', () => {
    fc.assert(
      fc.property(fc.array(fc.tuple(hostile, hostile, hostile), { minLength: 1, maxLength: 3 }), (texts) => {
        const levels = texts.map(([file, name, message]) =>
          brokenLevel({ file: `f${file}`, name, problems: [shownProblem({ message, frame: `  ${name}\n\`\`\`` })] }),
        );
        const text = checkMarkdown(resultsOf(levels), CONTEXT);
        const rows = rowsOf(text);
        expect(rows).toHaveLength(2 + texts.length);
        // a code span of another command never holds a bar, so each bar ends a cell
        for (const row of rows) expect(row.split('|')).toHaveLength(6);
        expect(
          text.replace(/<\/?(details|summary|code)>|<!-- -->/g, '').replace(/(`{3,})text[\s\S]*?\n *\1|`[^`\n]+`/g, ''),
        ).not.toMatch(/<[a-z/]/);
        expect(text).not.toMatch(/\p{Surrogate}/u);
      }),
    );
  });

  it('escapes what Markdown, HTML and GitHub would read', () => {
    expect(markdownText('a|b `c` <i> &lt; *d* @me #12 \\')).toBe(
      'a&#124;b \\`c\\` &#60;i&#62; &#38;lt; \\*d\\* @<!-- -->me #<!-- -->12 &#92;',
    );
    expect(markdownText('- x')).toBe('&#45; x');
    expect(markdownText('1. x')).toBe('&#49;. x');
    expect(markdownCode('levels/a b.json')).toBe('`levels/a b.json`');
    expect(markdownCode('a`|')).toBe('<code>a&#96;&#124;</code>');
    expect(markdownBlock('a\n```\nb')).toBe('````text\na\n```\nb\n````\n');
  });

  it('never takes more bytes than it may, and says what it leaves out', () => {
    const many = Array.from({ length: 40 }, (_, i) =>
      (i % 3 === 0 ? brokenLevel : checkedLevel)({ file: `levels/${i}é.level.json` }),
    );
    const whole = Buffer.byteLength(markdownWithin(resultsOf(many), null, MIB));
    fc.assert(
      fc.property(fc.integer({ min: -10, max: whole + 1000 }), (most) => {
        const text = markdownWithin(resultsOf(many), null, most);
        expect(Buffer.byteLength(text)).toBeLessThanOrEqual(Math.max(0, most));
        if (most > 1000) expect(text).toContain('### ❌ 14 of 40 levels fail');
        const rows = rowsOf(text).filter((row) => !/^\| (verdict|---)/.test(row));
        const isWhole = rows.length === 40 && text.match(/Look at it/g)?.length === 14;
        if (text !== '') expect(text.includes('Left out, as it did not fit: ')).toBe(!isWhole);
        const count = (words: RegExp): number => Number(words.exec(text)?.[1] ?? 0);
        if (text !== '') expect(rows.length + count(/(\d+) failing levels?/) + count(/(\d+) completable levels?[.;]/)).toBe(40);
      }),
    );
    const huge = Array.from({ length: 3000 }, (_, i) => brokenLevel({ file: `levels/${i}.level.json` }));
    expect(Buffer.byteLength(checkMarkdown(resultsOf(huge), CONTEXT))).toBeGreaterThan(COMMENT_BYTES - 2000);
  });
});

it('counts the failing levels of a set that are not listed', () => {
  const text = checkMarkdown(resultsOf([brokenLevel()], { unlisted: 41 }), CONTEXT);
  expect(text).toContain('Left out, as it did not fit: 41 failing levels.');
});

describe('the summary of a step', () => {
  const check = (summary: string) => gq(['check', '--format', 'github'], { cwd, env: { GITHUB_STEP_SUMMARY: summary } });

  it('gets the table after what is there, also with a report in a file', async () => {
    writeFileSync(at('summary.md'), 'before\n');
    expect(await check(at('summary.md'))).toMatchObject({ code: 1, stderr: '' });
    const text = readFileSync(at('summary.md'), 'utf8');
    expect(text).toMatch(/^before\n\n### ❌ 1 of 2 levels fails\n/);
    const { stdout } = await gq(['check', '--reporter', 'github=g.txt', '--format', 'markdown'], {
      cwd,
      env: { GITHUB_STEP_SUMMARY: at('second.md') },
    });
    expect(readFileSync(at('second.md'), 'utf8')).toBe(stdout);
    expect(text).toBe(`before\n\n${stdout}`);
  });

  it('names files as the annotations do, relative to the workspace', () => {
    const places = { directory: '/project/game', workspaces: ['/project'], root: '/project' };
    const { files: added } = stepSummary(at('none.md'), resultsOf([brokenLevel()]), { ...CONTEXT, places });
    expect(added[0].content).toContain('| `game/levels/a.level.json` |');
    expect(added[0].content).toContain('gq edit --open levels/a.level.json');
  });

  itQuick('stays below 1 MiB together with what is there', () => {
    const levels = Array.from({ length: 9000 }, (_, i) => brokenLevel({ file: `levels/${i}.level.json` }));
    for (const before of [0, 1000, MIB - 5000, MIB - 10, MIB + 5]) {
      writeFileSync(at('full.md'), 'x'.repeat(before));
      const { files: added, messages } = stepSummary(at('full.md'), resultsOf(levels), CONTEXT);
      for (const { path, content } of added) appendFileSync(path, String(content));
      const text = readFileSync(at('full.md'));
      expect(text.length).toBeLessThanOrEqual(Math.max(before, MIB));
      if (before < MIB - 1000) expect(text.toString()).toContain('Left out, as it did not fit: ');
      else expect(messages).toContain('the table of levels is left out');
    }
  });

  it('is a message where it cannot be written: the check did run', async () => {
    mkdirSync(at('closed'));
    for (const summary of [at('closed'), at('missing/summary.md')]) {
      const { code, stdout, stderr } = await check(summary);
      expect({ code, stdout: stdout.includes('::error') }).toEqual({ code: 1, stdout: true });
      expect(stderr).toMatch(/^warning: .*: can't be written: .*\n$/);
    }
    chmodSync(at('closed'), 0o755);
  });
});
