import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { validateXML } from 'xmllint-wasm';
import { checkJunit } from '../../../cli/reporters/junit.ts';
import { itQuick } from '../../depth.ts';
import { brokenLevel, CONTEXT, checkedLevel, resultsOf, shownProblem } from './context.ts';

const JENKINS = { ...CONTEXT, isJenkins: true };
const schema = {
  fileName: 'junit-10.xsd',
  contents: readFileSync(new URL('./fixtures/junit-10.xsd', import.meta.url), 'utf8'),
};

async function problemsIn(...reports: readonly string[]): Promise<string[]> {
  const { errors } = await validateXML({ xml: reports.map((contents, i) => ({ fileName: `${i}.xml`, contents })), schema });
  return errors.map(({ rawMessage }) => rawMessage);
}

const withoutEntities = (text: string): string =>
  text
    .replace(/&#(\d+);/g, (_, code: string) => String.fromCharCode(Number(code)))
    .replaceAll('&quot;', '"')
    .replaceAll('&lt;', '<')
    .replaceAll('&gt;', '>')
    .replaceAll('&amp;', '&');
const attributesOf = (head: string) =>
  Object.fromEntries([...head.matchAll(/ ([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, withoutEntities(value)]));
const casesIn = (xml: string) =>
  [...xml.matchAll(/<testcase( [^>]*)>([\s\S]*?)<\/testcase>/g)].map(([, head, body]) => ({
    ...attributesOf(head),
    state: /<(failure|error|skipped)[ >]/.exec(body)?.[1] ?? 'passed',
    body,
  }));

/** Texts that are hard to put into XML. */
const hostile = fc.string({
  unit: fc.oneof(
    fc.constantFrom(
      ']]>',
      '<',
      '&',
      '"',
      "'",
      '&#0;',
      '\u0000',
      '\u0008',
      '\r',
      '\n',
      '\t',
      '\u007f',
      '\ufffe',
      '\uffff',
      '🚀',
      '\u2028',
    ),
    fc.integer({ min: 0xd800, max: 0xdfff }).map((code) => String.fromCharCode(code)),
    fc.string({ unit: 'binary', maxLength: 3 }),
  ),
});

describe('the junit reporter', () => {
  it('gives every level its state, where Jenkins and GitLab look for it', () => {
    const unreadable = {
      unreadable: true,
      verdict: 'invalid' as const,
      problems: [shownProblem({ code: 'unreadable-file', line: null })],
    };
    const warning = shownProblem({ code: 'low-slack', severity: 'warning', message: 'tight', line: 4, column: 1 });
    const levels = [
      checkedLevel({ problems: [warning] }),
      brokenLevel({ file: 'levels/b.level.json' }),
      checkedLevel({ file: 'games/one/c.level.json', problems: [shownProblem({ code: 'slack-below-required' })] }),
      checkedLevel({ file: 'd.level.json', ...unreadable }),
      checkedLevel({
        file: 'levels/e.level.json',
        verdict: 'crashed',
        problems: [shownProblem({ code: 'crashed', line: null })],
      }),
    ];
    const xml = checkJunit(resultsOf(levels, { unchecked: ['levels/f.level.json'], interrupted: true }), CONTEXT);
    const cases = casesIn(xml.replace(/<testcase([^>]*)\/>/g, '<testcase$1></testcase>'));
    expect(cases.map(({ body: _, ...one }) => one)).toEqual([
      { classname: 'levels', name: 'a', file: 'levels/a.level.json', time: '0.001', state: 'passed' },
      { classname: 'levels', name: 'b', file: 'levels/b.level.json', time: '0.001', state: 'failure' },
      { classname: 'levels', name: 'e', file: 'levels/e.level.json', time: '0.001', state: 'error' },
      { classname: 'levels', name: 'f', file: 'levels/f.level.json', time: '0.000', state: 'skipped' },
      { classname: 'games.one', name: 'c', file: 'games/one/c.level.json', time: '0.001', state: 'failure' },
      { classname: 'levels', name: 'd', file: 'd.level.json', time: '0.001', state: 'error' },
    ]);
    expect(cases[0].body).toContain('levels/a.level.json:4:1: warning low-slack: tight');
    expect(cases[1].body).toContain('<failure message="broken: unknown key &quot;asteriods&quot;" type="run-does-not-complete">');
    for (const { body, state } of cases)
      expect(body.includes('gq edit --open')).toBe(state === 'failure' || body.includes('type="crashed"'));
    expect(cases[1].body).toContain('gq edit --open levels/b.level.json:120');
    const suites = [...xml.matchAll(/<testsuite( [^>]*)>/g)].map(([, head]) => attributesOf(head));
    expect(suites).toMatchObject([
      { name: 'levels', tests: '4', failures: '1', errors: '1', skipped: '1' },
      { name: 'games/one', tests: '1', failures: '1', errors: '0', skipped: '0' },
      { name: '.', tests: '1', failures: '0', errors: '1', skipped: '0' },
    ]);
  });

  it('is valid for Jenkins, whatever is in names and messages, and keeps what XML can hold', async () => {
    const reports: string[] = [];
    fc.assert(
      fc.property(fc.array(fc.tuple(hostile, hostile, hostile), { maxLength: 3 }), (texts) => {
        const levels = texts.map(([file, name, message]) =>
          brokenLevel({ file: `levels/${file}`, name, problems: [shownProblem({ message, hint: name, frame: file })] }),
        );
        const results = resultsOf(levels, { unchecked: texts.map(([file]) => file), interrupted: true });
        reports.push(checkJunit(results, JENKINS));
        // the only difference for other readers
        expect(checkJunit(results, CONTEXT).replace(/(<testcase[^>]*) file="[^"]*"/g, '$1')).toBe(reports.at(-1));
      }),
    );
    expect(await problemsIn(...reports)).toEqual([]);
  });

  it('says in each suite what is true of the whole check: too many warnings, levels that are not listed', async () => {
    const xml = checkJunit(resultsOf([brokenLevel()], { excess: '3 warnings', unlisted: 2 }), JENKINS);
    expect(xml).toContain('<system-err>3 warnings\nand 2 levels more that fail: --format json lists all levels\n</system-err>');
    expect(checkJunit(resultsOf([brokenLevel()], { unlisted: 0 }), JENKINS)).not.toContain('system-err');
    expect(await problemsIn(xml)).toEqual([]);
  });

  itQuick('would be refused with a raw character', async () => {
    const xml = checkJunit(resultsOf([brokenLevel()]), JENKINS);
    expect(await problemsIn(xml.replace('</failure>', '\u0001</failure>'))).not.toEqual([]);
    expect(await problemsIn(xml.replace('<testcase', '<testcase file="a"'))).not.toEqual([]);
  });
});
