import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, renameSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, describe, expect, it } from 'vitest';
import { goneUnder } from '../../cli/lock/index.ts';
import { lockKey } from '../../cli/lock/lock-file.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const NAMES = ['a', 'b', 'c', 'sub/d'] as const;
let files = makeFiles({});
let cwd = '';

function begin(): void {
  files = makeFiles(Object.fromEntries(NAMES.map((name) => [`levels/${name}.level.json`, fallThrough({ name })])));
  cwd = files.directory;
}
afterEach(() => files.remove());

const level = (name: string): string => join(cwd, `levels/${name}.level.json`);
const change = (name: string, changes: Readonly<Record<string, unknown>>): void =>
  writeFileSync(level(name), fallThrough({ name, ...changes }));
const lockText = (): string => readFileSync(join(cwd, 'gq.lock.json'), 'utf8');
const check = (...args: string[]) => gq(['check', ...args], { cwd });
const agree = (...args: string[]) => check(...args, '--update-lock');
const compare = async (...args: string[]) => {
  const { code, stdout, stderr } = await check(...args, '--lock', 'gq.lock.json', '--format', 'json');
  const { levels } = JSON.parse(stdout) as {
    levels: { file: string; problems: { code: string; message: string; line: number }[] }[];
  };
  const problems = levels.flatMap(({ file, problems }) => problems.map((problem) => ({ file, ...problem })));
  return { code, stderr, problems };
};

describe('gq check --lock', () => {
  it('says what has changed, at the run of the level, with the line of the lock', async () => {
    begin();
    expect(await agree()).toMatchObject({ code: 0, stderr: expect.stringMatching(/^gq\.lock\.json: agreed anew: 4 added\n/) });
    expect(await compare()).toEqual({ code: 0, stderr: '', problems: [] });
    change('b', { blackHole: { x: 180, y: 0 } });
    writeFileSync(level('c'), fallThrough({ name: 'c', runs: undefined }).replace('{', '{\n'));
    const { code, problems } = await compare();
    expect(code).toBe(1);
    const changed = problems.filter((problem) => problem.code === 'result-changed');
    expect(changed.map(({ file, message }) => [file, message])).toEqual([
      [
        'levels/b.level.json',
        expect.stringMatching(/^completed at tick \d+, before \d+(?:; certified .*)?; agreed on in gq\.lock\.json:5$/),
      ],
      ['levels/c.level.json', expect.stringMatching(/^unproven, before completable; no run was played, before completed at/)],
    ]);
    expect(changed[0]).toMatchObject({ line: 1, pointer: '/runs/0', severity: 'error' });
    const pretty = await check('--lock', 'gq.lock.json');
    expect(pretty.stdout).toContain('gq check levels/b.level.json --lock gq.lock.json --update-lock');
    expect(pretty.stdout).toContain('\n2 levels not as agreed on in the lock\n');
    const again = await agree('levels/b.level.json');
    expect(again.stderr).toMatch(
      /^gq\.lock\.json: agreed anew: 1 changed, 3 other entries kept\n {2}changed levels\/b\.level\.json: completed at/,
    );
    expect((await compare('levels/b.level.json')).problems).toEqual([]);
    expect((await compare()).problems.filter((problem) => problem.code === 'result-changed')).toHaveLength(1);
  });

  it('does not see what does not change the result, and writes nothing for it', async () => {
    begin();
    await agree();
    const before = lockText();
    change('a', { description: 'other words', minerals: [] });
    expect(await compare()).toMatchObject({ code: 0, problems: [] });
    expect((await agree()).stderr).toBe('gq.lock.json: nothing to write: 4 unchanged\n');
    expect(lockText()).toBe(before);
  });

  it('blames the rules when they differ, not the level', async () => {
    begin();
    await agree();
    writeFileSync(join(cwd, 'gq.config.json'), '{ "rules": { "pull": 45 } }');
    const { problems } = await compare();
    expect(problems).toHaveLength(4);
    for (const { message } of problems) expect(message).toMatch(/^the rules differ \(pull 45, before 39\): completed at tick/);
    expect((await agree()).stderr).toMatch(/changed levels\/a\.level\.json: completed at .*; rules: pull 45, before 39\n/);
  });

  it('fails for a level without an entry, and names entries whose level is gone', async () => {
    begin();
    await agree('levels/a.level.json', 'levels/sub');
    renameSync(level('sub/d'), level('sub/e'));
    const { code, problems, stderr } = await compare();
    expect(code).toBe(1);
    expect(problems.map(({ code, file }) => [code, file])).toEqual([
      ['not-in-lock', 'levels/b.level.json'],
      ['not-in-lock', 'levels/c.level.json'],
      ['not-in-lock', 'levels/sub/e.level.json'],
    ]);
    expect(stderr).toBe(
      'warning: gq.lock.json:5: the level levels/sub/d.level.json is gone; gq check --update-lock removes its entry\n',
    );
    // a check of other paths knows nothing of it
    expect(await compare('levels/a.level.json')).toEqual({ code: 0, stderr: '', problems: [] });
    await agree('levels/b.level.json');
    expect(lockText()).toContain('sub/d.level.json');
    expect((await agree()).stderr).toContain('\n  removed levels/sub/d.level.json: the level is gone\n');
    expect((await compare()).code).toBe(0);
  });

  it('means the same files from every working directory', async () => {
    begin();
    await agree();
    const inside = await gq(['check', '.', '--lock', '../gq.lock.json'], { cwd: join(cwd, 'levels') });
    expect(inside).toMatchObject({ code: 0, stderr: '' });
    const again = await gq(['check', '.', '--lock', '../../gq.lock.json', '--update-lock'], { cwd: join(cwd, 'levels/sub') });
    expect(again.stderr).toBe('../../gq.lock.json: nothing to write: 1 unchanged, 3 other entries kept\n');
    expect(lockKey('out/gq.lock.json', 'levels/a.level.json')).toBe('../levels/a.level.json');
  });

  it('refuses what can not be compared, and does nothing', async () => {
    begin();
    expect(await check('--lock', 'gq.lock.json')).toMatchObject({
      code: 2,
      stdout: '',
      stderr: expect.stringContaining('no lock file gq.lock.json'),
    });
    await agree('--accuracy', 'fast');
    expect(await check('--lock', 'gq.lock.json')).toMatchObject({
      code: 2,
      stdout: '',
      stderr: expect.stringMatching(
        /at the accuracy precise, but gq\.lock\.json has results at fast \(levels\/a\.level\.json, and 3 more levels\)/,
      ),
    });
    expect((await check('--lock', 'gq.lock.json', '--accuracy', 'fast')).code).toBe(0);
    const good = lockText();
    writeFileSync(join(cwd, 'gq.lock.json'), good.replace('"verdict"', '"verdikt"'));
    for (const more of [[], ['--update-lock']]) {
      const { code, stderr } = await check('--lock', 'gq.lock.json', '--accuracy', 'fast', ...more);
      expect(code).toBe(2);
      expect(stderr).toMatch(/gq\.lock\.json:4:\d+: error unknown-key: .*did you mean "verdict"\?/);
    }
    writeFileSync(join(cwd, 'gq.lock.json'), `<<<<<<< ours\n${good}`);
    expect((await check('--lock', 'gq.lock.json')).stderr).toMatch(
      /gq\.lock\.json:1:1: .*git checkout --ours -- gq\.lock\.json/s,
    );
  });

  it('keeps an entry of a level that can not be read, and never writes after --bail', async () => {
    begin();
    await agree();
    const before = lockText();
    rmSync(level('a'));
    symlinkSync('nowhere', level('a'));
    const unread = await agree();
    expect(unread).toMatchObject({
      code: 2,
      stderr: expect.stringContaining('  kept levels/a.level.json: it could not be checked'),
    });
    expect(lockText()).toBe(before);
    change('b', { blackHole: { x: 180, y: 0 } });
    change('c', { runs: [] });
    const ended = await agree('levels/b.level.json', 'levels/c.level.json', 'levels/sub', '--bail', '1');
    expect(ended).toMatchObject({
      code: 1,
      stderr: expect.stringContaining('gq.lock.json: not updated, because not every level'),
    });
    expect(lockText()).toBe(before);
  });
});

it('versions of a lock merge in git when different levels have changed', async () => {
  begin();
  const git = (...args: string[]) =>
    execFileSync('git', ['-c', 'user.name=t', '-c', 'user.email=t@t', '-c', 'core.autocrlf=false', ...args], {
      cwd,
      encoding: 'utf8',
      stdio: 'pipe',
    });
  git('init', '-q', '-b', 'main');
  await agree();
  git('add', '.');
  git('commit', '-qm', 'all');
  git('checkout', '-qb', 'other');
  change('sub/d', { blackHole: { x: 180, y: 0 } });
  await agree();
  git('commit', '-qam', 'd');
  git('checkout', '-q', 'main');
  change('a', { blackHole: { x: 190, y: 0 } });
  await agree();
  git('commit', '-qam', 'a');
  git('merge', '-q', 'other', '-m', 'both');
  expect(await compare()).toMatchObject({ code: 0, problems: [] });
  expect((await agree()).stderr).toBe('gq.lock.json: nothing to write: 4 unchanged\n');
});

describe('an entry is gone', () => {
  it('only if its file is missing below the checked paths', () => {
    begin();
    const at = (path: string): string => join(cwd, path);
    expect(existsSync(at('levels/a.level.json'))).toBe(true);
    const gone = goneUnder([at('levels')]);
    expect([at('levels/a.level.json'), at('levels/x.level.json'), at('levels2/x.level.json')].map(gone)).toEqual([
      false,
      true,
      false,
    ]);
    const byPattern = goneUnder([at('levels/sub/*.json')]);
    expect([at('levels/x.level.json'), at('levels/sub/x.level.json'), at('levels/sub/d.level.json')].map(byPattern)).toEqual([
      false,
      true,
      false,
    ]);
    expect(goneUnder([at('levels/x.level.json')])(at('levels/x.level.json'))).toBe(true);
  });
});

describe('gq check --bail', () => {
  it('ends the report with the Nth level that fails, for any number of threads', async () => {
    begin();
    for (const name of ['b', 'c', 'sub/d'] as const) change(name, { runs: [] });
    for (const [most, last] of [
      [1, 1],
      [2, 2],
      [3, 3],
      [9, 3],
    ]) {
      for (const jobs of ['1', '2']) {
        const { code, stdout } = await check('--bail', String(most), '--jobs', jobs, '--require-slack', '1', '--format', 'json');
        const { levels, unchecked } = JSON.parse(stdout);
        expect([code, levels.map(({ name }: { name: string }) => name)]).toEqual([1, NAMES.slice(0, last + 1)]);
        expect(unchecked).toEqual(NAMES.slice(last + 1).map((name) => `levels/${name}.level.json`));
      }
    }
  });

  it('refuses a count that is none', async () => {
    begin();
    for (const count of ['0', '-1', 'x', '1.5']) expect((await check('--bail', count)).code).toBe(2);
  });
});
