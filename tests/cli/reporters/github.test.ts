import { mkdirSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { checkGithub } from '../../../cli/reporters/github.ts';
import { fallThrough, gq, makeFiles } from '../gq.ts';
import { brokenLevel, CONTEXT, checkedLevel, resultsOf, shownProblem } from './context.ts';

/** Reads workflow commands as GitHub does. */
function annotations(text: string) {
  const unescaped = (value: string): string =>
    value.replaceAll('%3A', ':').replaceAll('%2C', ',').replaceAll('%0D', '\r').replaceAll('%0A', '\n').replaceAll('%25', '%');
  return text.split('\n').flatMap((line) => {
    const found = /^::(error|warning) (.*?)::(.*)$/.exec(line);
    if (found === null) return [];
    const properties = Object.fromEntries(found[2].split(',').map((part) => part.split('=').map(unescaped)));
    return [{ severity: found[1], message: unescaped(found[3]), ...properties } as Record<string, string>];
  });
}

const files = makeFiles({
  'game/levels/a.level.json': fallThrough({ asteriods: [] }),
  'elsewhere/b.level.json': fallThrough({ runs: [] }),
});
afterAll(() => files.remove());

describe('the github reporter', () => {
  it('names files relative to the workspace, also through a link, and others as they were given', async () => {
    const cwd = join(files.directory, 'game');
    symlinkSync(files.directory, join(files.directory, 'link'));
    mkdirSync(join(files.directory, 'game/out'));
    const named = async (workspace: string, ...paths: string[]) => {
      const { stdout } = await gq(['check', ...paths, '--format', 'github'], {
        cwd,
        env: { GITHUB_WORKSPACE: workspace },
      });
      return annotations(stdout).map(({ file }) => file);
    };
    const both = ['levels', '../elsewhere'];
    expect(await named(files.directory, ...both)).toEqual(['game/levels/a.level.json', 'elsewhere/b.level.json']);
    expect(await named(join(files.directory, 'link'), ...both)).toEqual(['game/levels/a.level.json', 'elsewhere/b.level.json']);
    expect(await named(cwd, ...both)).toEqual(['levels/a.level.json', '../elsewhere/b.level.json']);
    expect(await named('', ...both)).toEqual(['levels/a.level.json', '../elsewhere/b.level.json']);
  });

  it('is there for gq fmt --check: what would change and what is invalid, at the same paths', async () => {
    const { code, stdout } = await gq(['fmt', '--check', 'levels', '../elsewhere', '--format', 'github'], {
      cwd: join(files.directory, 'game'),
      env: { GITHUB_WORKSPACE: files.directory },
    });
    expect(code).toBe(1);
    expect(annotations(stdout)).toEqual([
      expect.objectContaining({ severity: 'error', file: 'game/levels/a.level.json', line: '1', title: 'unknown-key' }),
      {
        severity: 'error',
        file: 'elsewhere/b.level.json',
        title: 'layout',
        message: 'the layout is not the canonical one\nto format it: gq fmt ../elsewhere/b.level.json',
      },
    ]);
    expect(stdout).toMatch(/\n2 files: 1 would change, 1 invalid\n$/);
  });

  it('says everything about a problem, whatever is in its texts', () => {
    const text = fc.string({ unit: fc.constantFrom('a', '%', ':', ',', '\n', '\r', '%0A', '::', '=') });
    fc.assert(
      fc.property(text, text, (message, hint) => {
        const problem = shownProblem({ message: `m${message}`, hint: `h${hint}`, line: 3, column: 7 });
        const [found] = annotations(checkGithub(resultsOf([brokenLevel({ problems: [problem] })]), CONTEXT));
        expect(found).toMatchObject({ severity: 'error', file: 'levels/a.level.json', line: '3', endLine: '3', col: '7' });
        expect(found).toMatchObject({ title: 'unknown-key' });
        expect(found.message).toBe(`m${message}\nh${hint}\nlook at it: gq edit --open levels/a.level.json:120`);
      }),
    );
  });

  it('puts errors first, since GitHub shows ten of each', () => {
    const warned = checkedLevel({ problems: [shownProblem({ severity: 'warning', hint: '' })] });
    const found = annotations(checkGithub(resultsOf([warned, brokenLevel(), warned, brokenLevel()]), CONTEXT));
    expect(found.map(({ severity }) => severity)).toEqual(['error', 'error', 'warning', 'warning']);
    expect(found[2].message).toBe('unknown key "asteriods"');
  });

  it.each([
    [10, 10, null],
    [11, 10, '1 more error not shown here'],
    [3, 12, '2 more warnings not shown here'],
    [30, 11, '20 more errors and 1 more warning not shown here'],
  ])('says with %i errors and %i warnings what GitHub does not show', (errors, warnings, said) => {
    const warned = checkedLevel({ problems: [shownProblem({ severity: 'warning' })] });
    const levels = [...Array(warnings).fill(warned), ...Array(errors).fill(brokenLevel())];
    const text = checkGithub(resultsOf(levels), CONTEXT);
    expect(annotations(text)).toHaveLength(errors + warnings);
    const notices = text.split('\n').filter((line) => line.startsWith('::notice'));
    if (said === null) expect(notices).toEqual([]);
    else expect(notices).toEqual([expect.stringMatching(`^::notice title=more problems::${said}: GitHub shows 10 of each`)]);
  });

  it('leaves out warnings if it is to be quiet', () => {
    const warned = checkedLevel({ problems: [shownProblem({ severity: 'warning' })] });
    const found = annotations(checkGithub(resultsOf([warned, brokenLevel()]), { ...CONTEXT, quiet: true }));
    expect(found.map(({ severity }) => severity)).toEqual(['error']);
  });

  it('gives no command that is in the name of a file, as GitHub reads one after any spaces', () => {
    const name = '::add-mask::x.level.json';
    const texts = [
      checkGithub(resultsOf([], { unchecked: [name], interrupted: true }), CONTEXT),
      checkGithub(resultsOf([brokenLevel({ file: name, name })]), CONTEXT),
    ];
    for (const line of texts.join('').split('\n')) expect(line.trim()).not.toMatch(/^::(?!error |warning )/);
    expect(texts[0]).toContain(name);
  });
});
