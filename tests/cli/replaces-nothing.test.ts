import { existsSync, linkSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import { SUMMED_UP } from '../../cli/io/replaceable.ts';
import { REPORTER_NAMES } from '../../cli/reporters/reporter.ts';
import { PLAY_VERDICTS } from '../../game/index.ts';
import { VERDICTS } from '../../schema/basics/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const removals: (() => void)[] = [];
afterAll(() => {
  for (const remove of removals) remove();
});

const BASHRC = 'alias ls="ls --color"\n';
const LEVEL = fallThrough();

/** A clone of a stranger's repository in `repo`, and what is beside it. */
let place = '';
let repo = '';
beforeEach(() => {
  const made = makeFiles({
    'repo/levels/a.level.json': LEVEL,
    'repo/levels/b.level.json': fallThrough({ name: 'Second' }),
    'repo/.git/HEAD': 'ref: refs/heads/main\n',
    'repo/.git/hooks/pre-commit.sample': 'exit 0\n',
    'victim/.bashrc': BASHRC,
    'victim/levels/mine.level.json': LEVEL,
  });
  removals.push(made.remove);
  place = made.directory;
  repo = join(place, 'repo');
});

const put = (name: string, content: string): void => writeFileSync(join(repo, name), content);
const textOf = (name: string): string => readFileSync(join(repo, name), 'utf8');
const run = (args: readonly string[], cwd = repo) => gq(args, { cwd });

describe('paths of a configuration', () => {
  const refused = async (config: object, message: RegExp): Promise<void> => {
    put('gq.config.json', JSON.stringify(config));
    for (const args of [['check'], ['check', '--update-lock'], ['fmt'], ['check', 'levels/a.level.json']]) {
      const { code, stdout, stderr } = await run(args);
      expect({ code, stdout, stderr }).toEqual({ code: 2, stdout: '', stderr: expect.stringMatching(message) });
    }
    expect(readFileSync(join(place, 'victim/.bashrc'), 'utf8')).toBe(BASHRC);
    expect(existsSync(join(place, 'victim/new'))).toBe(false);
    expect(existsSync(join(repo, '.git/hooks/pre-commit'))).toBe(false);
  };
  const OUT = /^error: nothing was done: gq\.config\.json:1:\d+: ".*" leads to \S+, outside of \S+: expected a path inside/;

  it.each([
    { reporters: ['pretty=../victim/.bashrc'] },
    { reporters: ['json=../victim/new'] },
    { reporters: ['github', 'json=levels/../../victim/new'] },
    { reporters: ['json=/nowhere/new'] },
    { lock: '../victim/new' },
    { cache: '../victim/new' },
    { levels: '../victim/levels' },
    { levels: ['levels', '../victim/**/*.level.json'] },
  ])('stay in its repository: %j', async (config) => {
    await refused(config, OUT);
  });

  it.each([
    { reporters: ['pretty=.git/hooks/pre-commit'] },
    { reporters: ['pretty=levels/../.GIT/hooks/pre-commit'] },
    { reporters: ['pretty=.git/config'] },
    { lock: '.git/lock.json' },
    { cache: '.git' },
  ])("keep away from git's own files: %j", (config) => refused(config, /among git's own files: expected a path inside/));

  it.each([{ reporters: ['json=C:\\victim\\new'] }, { reporters: ['json=C:/victim/new'] }, { lock: '\\\\host\\share\\x' }])(
    'are no absolute paths of Windows: %j',
    (config) => refused(config, process.platform === 'win32' ? OUT : /is an absolute path of Windows/),
  );

  it.skipIf(process.platform === 'win32')('count by where links lead, broken ones too', async () => {
    symlinkSync('../victim', join(repo, 'out'));
    symlinkSync('../victim/new', join(repo, 'broken'));
    symlinkSync('broken', join(repo, 'again'));
    symlinkSync('.git/hooks', join(repo, 'hooks'));
    symlinkSync('round', join(repo, 'round'));
    await refused({ reporters: ['pretty=out/.bashrc'] }, OUT);
    await refused({ reporters: ['pretty=out/new'] }, OUT);
    await refused({ reporters: ['pretty=broken'] }, OUT);
    await refused({ reporters: ['pretty=again'] }, OUT);
    await refused({ levels: 'out/levels' }, OUT);
    await refused({ reporters: ['pretty=hooks/pre-commit'] }, /among git's own files/);
    await refused({ reporters: ['pretty=round'] }, /leads to nowhere: its symbolic links go round in circles/);
  });

  it('may lead anywhere in it, from a folder below as well', async () => {
    mkdirSync(join(repo, 'game'));
    put(
      'game/gq.config.json',
      JSON.stringify({ levels: '../levels', reporters: ['json=../out/report.json'], cache: '../.cache' }),
    );
    expect((await run(['check'], join(repo, 'game'))).code).toBe(0);
    expect(JSON.parse(textOf('out/report.json')).levels).toHaveLength(2);
  });
});

it('every verdict may stand in the last line of a report', () => {
  expect(SUMMED_UP.split(' ').sort()).toEqual([...VERDICTS, ...PLAY_VERDICTS].sort());
});

describe('a report', () => {
  it('replaces an earlier report of any kind, an empty file and none', async () => {
    put('broken.level.json', fallThrough({ runs: [] }));
    for (const paths of [['levels'], ['broken.level.json'], ['levels', '--accuracy', 'arcade', '--max-time', '90']])
      for (const before of REPORTER_NAMES)
        for (const after of ['json', 'pretty']) {
          await run(['check', ...paths, '--reporter', `${before}=r.txt`, '--reporter', 'json=j.json']);
          const { stderr } = await run(['check', ...paths, '--reporter', `${after}=r.txt`]);
          expect(`${before} ${after} ${stderr}`).toBe(`${before} ${after} `);
        }
    put('empty', '');
    expect((await run(['check', '--reporter', 'json=empty'])).code).toBe(0);
    expect(JSON.parse(textOf('empty')).version).toBe(1);
  });

  it.each([
    ['notes.md', '# Notes\n\n22 levels are a lot.\n'],
    ['README.md', '# My levels\n\nThree of them.\n'],
    ['plan.md', '### ✅ Done\n\n3 levels, all of them\n'],
    ['todo.txt', 'To do:\n3 levels: 2 hard\n'],
    ['long.txt', `3 levels: 3 completable\n${'Then I wrote much more.\n'.repeat(30)}`],
    ['.bashrc', BASHRC],
    ['package.json', '{ "version": "1.0.0", "levels": [] }\n'],
    ['pack.json', '{ "version": 1, "levels": [{ "level": "a" }] }\n'],
    ['gq.lock.json', '{ "version": 1, "levels": {} }\n'],
    ['picture.svg', '<svg xmlns="http://www.w3.org/2000/svg"/>\n'],
    ['index.xml', '<?xml version="1.0"?>\n<testsuites name="jest tests"/>\n'],
  ])('replaces no other file without --force: %s', async (name, content) => {
    put(name, content);
    for (const reporter of ['pretty', 'json']) {
      const { code, stdout, stderr } = await run(['check', 'levels', '--reporter', `${reporter}=${name}`]);
      expect({ code, stdout, stderr }).toEqual({
        code: 2,
        stdout: '',
        stderr: expect.stringMatching(/would replace \S+, which is no report of gq; give it another file, or --force/),
      });
      expect(textOf(name)).toBe(content);
    }
    expect((await run(['check', 'levels', '--reporter', `json=${name}`, '--force'])).code).toBe(0);
    expect(JSON.parse(textOf(name)).levels).toHaveLength(2);
  });

  it('never replaces a level, not even with --force, whatever its name', async () => {
    put('other.txt', LEVEL);
    put('half.level.json', '{');
    for (const name of ['other.txt', 'half.level.json', 'levels/a.level.json']) {
      const before = textOf(name);
      const { code, stderr } = await run(['check', 'levels/b.level.json', '--reporter', `pretty=${name}`, '--force']);
      expect({ code, stderr }).toEqual({
        code: 2,
        stderr: expect.stringMatching(/would replace a level(?: that is checked)?; give it another file/),
      });
      expect(textOf(name)).toBe(before);
    }
  });
});

describe('output of a command', () => {
  const COMMANDS: readonly (readonly [string, (out: string) => readonly string[], 'svg' | 'json'])[] = [
    ['check', (out) => ['check', 'levels/a.level.json', '--force', '--reporter', `json=${out}`], 'svg'],
    ['render', (out) => ['render', 'levels/a.level.json', '-o', out], 'svg'],
    ['accuracy', (out) => ['accuracy', 'levels/a.level.json', '--svg', out], 'svg'],
    ['tune', (out) => ['tune', 'levels/a.level.json', '--set', 'pull=1.1x', '--svg', out], 'svg'],
    ['difficulty', (out) => ['difficulty', 'levels/a.level.json', '--svg', out], 'svg'],
    ['diff', (out) => ['diff', 'levels/a.level.json', 'levels/b.level.json', '-o', out], 'svg'],
    ['plan', (out) => ['plan', 'levels/a.level.json', '--shards', '2', '--force', '-o', out], 'svg'],
    ['export', (out) => ['export', 'levels/a.level.json', '--to', 'gravityquest', '--drop', '--force', '-o', out], 'json'],
  ];

  it.each(COMMANDS)('of gq %s replaces nothing that it reads, nor another level, by no name', async (_, command, ending) => {
    linkSync(join(repo, 'levels/a.level.json'), join(repo, `hard.${ending}`));
    const names = [`hard.${ending}`];
    if (process.platform !== 'win32') {
      symlinkSync('levels/a.level.json', join(repo, `soft.${ending}`));
      symlinkSync('levels/b.level.json', join(repo, `second.${ending}`));
      names.push(`soft.${ending}`, `second.${ending}`);
    }
    const before = [textOf('levels/a.level.json'), textOf('levels/b.level.json')];
    for (const name of names) {
      const { code, stderr } = await run(command(name));
      expect({ name, code, stderr }).toEqual({
        name,
        code: 2,
        stderr: expect.stringMatching(/replace|is no plan|this is none/),
      });
      expect([textOf('levels/a.level.json'), textOf('levels/b.level.json')]).toEqual(before);
    }
  });
});
