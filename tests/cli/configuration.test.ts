import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, describe, expect, it } from 'vitest';
import { ignoreOf } from '../../cli/find/index.ts';
import * as fc from '../fast-check.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const good = fallThrough();
/** Its run forgives less than a second. */
const SWING = readFileSync(new URL('../../levels/02-first-swing.level.json', import.meta.url), 'utf8');
/** Two asteroids at one place: the warnings same-place and overlapping. */
const warned = (more: object = {}) =>
  fallThrough({
    asteroids: [
      { x: 100, y: 0, radius: 16 },
      { x: 100, y: 0, radius: 16 },
    ],
    ...more,
  });
const broken = (more: object = {}) => fallThrough({ runs: [{ name: 'none', holds: [] }], ...more });

let made: ReturnType<typeof makeFiles> | null = null;
afterEach(() => made?.remove());

/** Makes a project, with its configuration. */
function project(
  config: object | string,
  files: Readonly<Record<string, string>>,
): (args: string, folder?: string) => ReturnType<typeof gq> {
  const text = typeof config === 'string' ? config : JSON.stringify(config);
  made = makeFiles({ '.git/HEAD': '', 'gq.config.json': text, ...files });
  const { directory } = made;
  return (args, folder = '.') => gq(args.split(' '), { cwd: join(directory, folder) });
}

interface Checked {
  readonly file: string;
  readonly problems: readonly { readonly code: string; readonly severity: string }[];
}
const levelsOf = (stdout: string): readonly Checked[] => JSON.parse(stdout).levels;
const filesOf = (stdout: string): string[] => levelsOf(stdout).map(({ file }) => file.replaceAll('\\', '/'));
const codesOf = (stdout: string): string[] =>
  levelsOf(stdout).flatMap(({ problems }) => problems.map(({ code, severity }) => `${code} ${severity}`));

describe('levels and ignore', () => {
  const files = {
    'game/a.level.json': good,
    'game/drafts/b.level.json': good,
    'game/drafts/keep.level.json': good,
    'more/c.level.json': good,
  };

  it('choose what is checked when no path is given, from any folder below', async () => {
    const run = project({ levels: ['game', 'more/*.level.json'], ignore: ['drafts', '!keep.level.json'] }, files);
    const chosen = ['game/a.level.json', 'game/drafts/keep.level.json', 'more/c.level.json'];
    expect(filesOf((await run('check --format json')).stdout)).toEqual(chosen);
    expect(filesOf((await run('check --format json', 'more')).stdout)).toEqual(
      chosen.map((file) => (file.startsWith('more/') ? 'c.level.json' : `../${file}`)),
    );
    expect((await run('fmt --check')).stdout).toContain('3 files');
    // a file that is named is checked all the same
    expect(filesOf((await run('check game/drafts/b.level.json --format json')).stdout)).toHaveLength(1);
    expect(filesOf((await run('check game --no-config --format json')).stdout)).toHaveLength(3);
  });

  it('are never green when everything is ignored', async () => {
    const run = project({ levels: 'game', ignore: ['game'] }, files);
    for (const args of ['check', 'check game', 'check game/**', 'fmt']) {
      const { code, stdout, stderr } = await run(args);
      expect([code, stdout]).toEqual([2, '']);
      expect(stderr).toContain('in gq.config.json, "game" ignores 3');
    }
  });

  it('say that a path is one of the configuration if nothing is there', async () => {
    const { code, stderr } = await project({ levels: 'gone' }, files)('check');
    expect(code).toBe(2);
    expect(stderr).toContain('gone: no such file or directory');
    expect(stderr).toContain('"levels" of gq.config.json');
  });

  it('read patterns as in .gitignore', async () => {
    const ignored = async (patterns: readonly string[], file: string) =>
      (await ignoreOf({ directory: '/game', ignore: patterns }))(join('/game', file));
    for (const [pattern, file, isIgnored] of [
      ['drafts', 'a/drafts/b/c.level.json', true],
      ['drafts/', 'drafts/c.level.json', true],
      ['c.level.json/', 'drafts/c.level.json', false],
      ['/drafts', 'a/drafts/c.level.json', false],
      ['./drafts', 'drafts/c.level.json', true],
      ['a/drafts', 'b/a/drafts/c.level.json', false],
      ['**/old/**', 'a/old/c.level.json', true],
      ['*.wip.level.json', 'a/b.wip.level.json', true],
      ['a/*.level.json', 'a/b/c.level.json', false],
      ['.hidden.level.json', '.hidden.level.json', true],
      ['draft', 'drafts/c.level.json', false],
    ] as const)
      expect((await ignored([pattern], file)) !== null, `${pattern} ${file}`).toBe(isIgnored);
    expect(await ignored(['drafts', '!c.level.json', 'c.*'], 'drafts/c.level.json')).toBe('c.*');
  });

  it('leave out no file that no pattern matches, whatever the patterns', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(fc.string({ minLength: 1, maxLength: 8 }), { maxLength: 4 }), async (patterns) => {
        const ignore = await ignoreOf({ directory: '/game', ignore: patterns });
        const by = ignore('/game/a/b.level.json');
        if (by !== null) expect(patterns).toContain(by);
      }),
    );
  });
});

describe('severity, allow and limits', () => {
  it('change severities and exit codes, but no verdict', async () => {
    const run = project(
      { severity: { 'same-place': 'error', 'unused-asteroid': 'off', 'run-does-not-complete': 'off' } },
      { 'levels/a.level.json': warned() },
    );
    const raised = await run('check --format json');
    expect(raised.code).toBe(1);
    expect(codesOf(raised.stdout)).toContain('same-place error');
    expect(codesOf(raised.stdout).some((code) => code.startsWith('unused-asteroid'))).toBe(false);
    expect((await run('check --no-config')).code).toBe(0);
    writeFileSync(join(made!.directory, 'levels/b.level.json'), broken());
    const { code, stdout } = await run('check levels/b.level.json --format json');
    expect([code, codesOf(stdout)]).toEqual([1, ['run-does-not-complete error']]);
  });

  it('limit warnings, where the command line wins', async () => {
    const run = project({ maxWarnings: 0 }, { 'levels/a.level.json': warned() });
    const strict = await run('check');
    expect(strict.code).toBe(1);
    expect(strict.stdout).toMatch(/\d warnings?: at most 0 allowed \(--max-warnings\)/);
    const json = await run('check --format json');
    expect([json.code, json.stderr]).toEqual([1, expect.stringMatching(/^error: \d warnings?: at most 0 allowed/)]);
    expect((await run('check --max-warnings 9')).code).toBe(0);
    const quiet = await run('check --quiet --max-warnings 9');
    expect(quiet.stdout).toMatch(/^1 level: 1 completable; \d warnings?\n$/);
    expect((await run('check --quiet')).code).toBe(1);
  });

  it('allow a problem with a reason, which is counted, and warn where it is not there', async () => {
    const allow = { 'same-place': 'twins', 'unused-asteroid': 'twins' };
    const run = project({}, { 'levels/a.level.json': warned({ allow: { ...allow, 'holds-overlap': 'never' } }) });
    const { code, stdout } = await run('check --max-warnings 1');
    expect(code).toBe(0);
    expect(stdout).toMatch(/a\.level\.json:1:\d+: warning unused-allow: the level allows holds-overlap/);
    expect(stdout).toMatch(/completable; \d problems? allowed/);
    expect(stdout).not.toContain('warning same-place');
  });

  it('never call an allow unused that was not looked for', async () => {
    const allow = { 'low-slack': 'for experts', 'slack-below-required': 'for experts', 'found-run': 'yes' };
    const run = project({}, { 'levels/a.level.json': fallThrough({ allow }) });
    expect(codesOf((await run('check --format json')).stdout)).toEqual([]);
    const required = codesOf((await run('check --require-slack 1 --format json')).stdout);
    expect(required.filter((code) => code !== 'unused-allow warning')).toEqual([]);
    expect(codesOf((await run('check --require-slack 1 --no-require-slack --format json')).stdout)).toEqual([]);
  });

  it('keep allow through fmt, one line for each problem, in one order', async () => {
    const run = project({}, { 'a.level.json': fallThrough({ allow: { overlapping: 'b', 'low-slack': 'a', 'x-note': 1 } }) });
    expect((await run('fmt a.level.json')).code).toBe(0);
    const { stdout } = await run('fmt a.level.json --check');
    expect(stdout).toContain('1 unchanged');
  });
});

describe('the file', () => {
  it('can be named, relative to the working directory, and its paths are relative to it', async () => {
    const run = project('{', { 'game/other.json': '{ "levels": "in" }', 'game/in/a.level.json': good });
    const { code, stdout } = await run('check --config game/other.json --format json');
    expect([code, filesOf(stdout)]).toEqual([0, ['game/in/a.level.json']]);
    for (const args of [
      'check game',
      'fmt game',
      'simulate game/in/a.level.json',
      'inspect game/in/a.level.json',
      'tune game --set pull=1.1x',
    ]) {
      expect((await run(args)).code, args).toBe(2);
      expect((await run(`${args} --no-config`)).code, args).not.toBe(2);
    }
    const gone = await run('check --config nope.json');
    expect([gone.code, gone.stdout]).toEqual([2, '']);
    expect(gone.stderr).toContain("nope.json: can't be read: no such file or directory");
  });

  it('sets defaults of accuracy and slack', async () => {
    const run = project({ accuracy: 'arcade', requireSlack: 60 }, { 'levels/a.level.json': SWING });
    const { code, stdout } = await run('check --format json');
    expect(code).toBe(1);
    expect(JSON.parse(stdout).levels[0].run.accuracy).toBe('arcade');
    expect(codesOf(stdout)).toContain('slack-below-required error');
    const other = await run('check --accuracy fast --no-require-slack --format json');
    expect([other.code, JSON.parse(other.stdout).levels[0].run.accuracy]).toEqual([0, 'fast']);
    expect(JSON.parse((await run('simulate levels/a.level.json --format json')).stdout).accuracy).toBe('arcade');
  });

  it('sets reports, whose files are relative to it, and --format wins for stdout', async () => {
    const run = project({ reporters: ['json=out.json', 'github'] }, { 'levels/a.level.json': good });
    mkdirSync(join(made!.directory, 'deep'));
    const { code, stdout } = await run('check ../levels --format json', 'deep');
    expect(code).toBe(0);
    expect(JSON.parse(readFileSync(join(made!.directory, 'out.json'), 'utf8')).summary).toEqual(JSON.parse(stdout).summary);
  });

  it('has a JSON Schema that gq schema prints', async () => {
    const run = project({}, {});
    expect(JSON.parse((await run('schema config')).stdout).properties.severity).toBeDefined();
    const { code, stderr } = await run('schema confg');
    expect([code, stderr]).toEqual([2, expect.stringContaining('did you mean config?')]);
  });
});
