import { execFileSync, spawnSync } from 'node:child_process';
import { chmodSync, cpSync, mkdirSync, readFileSync, renameSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import { once } from '../once.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';

const removals: (() => void)[] = [];
afterAll(() => {
  for (const remove of removals) remove();
});

const NAMES = ['a', 'b', 'c', 'sub/d', "odd 'né' $(x)"];

/** A repository with one commit. */
const original = once((): string => {
  const { directory, remove } = makeFiles(
    Object.fromEntries(NAMES.map((name) => [`game/levels/${name}.level.json`, fallThrough({ name })])),
  );
  removals.push(remove);
  git(directory, 'init', '-q', '-b', 'main', '--template=');
  commit(directory);
  return directory;
});

function makeRepository(): string {
  const { directory, remove } = makeFiles({});
  removals.push(remove);
  cpSync(original(), directory, { recursive: true });
  return directory;
}

const git = (cwd: string, ...args: string[]): string =>
  execFileSync('git', ['-c', 'user.name=t', '-c', 'user.email=t@t', '-c', 'protocol.file.allow=always', ...args], {
    cwd,
    encoding: 'utf8',
    stdio: 'pipe',
  });

function commit(root: string): void {
  git(root, 'add', '-A');
  git(root, 'commit', '-qm', 'commit');
}

let root = '';
let game = '';
beforeEach(() => {
  root = makeRepository();
  game = join(root, 'game');
});

const write = (name: string, content = fallThrough({ name: `new ${name}` })): void =>
  writeFileSync(join(game, `levels/${name}.level.json`), content);

/** The names of the files that were checked, and what was said. */
async function checked(args: readonly string[], cwd = game) {
  const { code, stdout, stderr } = await gq(['check', ...args, '--format', 'json'], { cwd });
  if (code === 2) return { code, stderr, names: [] };
  const { levels } = JSON.parse(stdout) as { levels: { file: string }[] };
  return { code, stderr, names: levels.map(({ file }) => file.replace(/^levels\/|\.level\.json$/g, '')) };
}

describe('gq check --changed', () => {
  it('checks all levels when the configuration that --config names has changed, wherever it is', async () => {
    mkdirSync(join(root, 'conf'));
    const config = join(root, 'conf/strict.json');
    writeFileSync(config, '{ "levels": "../game/levels" }');
    commit(root);
    const args = ['--changed', '--config', '../conf/strict.json'];
    expect((await checked(args)).names).toEqual([]);
    writeFileSync(config, '{ "levels": "../game/levels", "rules": { "pull": 10 } }');
    const { names, stderr } = await checked(args);
    expect(names).toHaveLength(NAMES.length);
    expect(stderr).toMatch(/^all 5 levels checked: ..\/conf\/strict.json has changed since main/);
  });

  it('checks levels whose entry in the lock has changed', async () => {
    const lock = join(game, 'gq.lock.json');
    await gq(['check', '--update-lock'], { cwd: game });
    commit(root);
    const args = ['--changed', '--lock', 'gq.lock.json'];
    expect(await checked(args)).toMatchObject({ code: 0, names: [] });
    const before = readFileSync(lock, 'utf8');
    writeFileSync(lock, before.replace(/("levels\/b.level.json".*"tick": ?)\d+/, '$17'));
    expect(await checked(args)).toMatchObject({ code: 1, names: ['b'] });
    expect(await checked(['--changed'])).toMatchObject({ code: 0, names: [] });
    // an entry that is gone
    writeFileSync(lock, before.replace(/.*"levels\/b.level.json".*\n/, ''));
    expect(await checked(args)).toMatchObject({ code: 1, names: ['b'] });
    // a lock that is gone
    rmSync(lock);
    expect(await checked(args)).toMatchObject({ code: 2, stderr: expect.stringContaining('there is no lock file') });
    expect(await checked([...args, '--update-lock'])).toMatchObject({ code: 0, names: expect.arrayContaining(['a', 'b']) });
    // a new lock
    git(root, 'rm', '-q', '--cached', 'game/gq.lock.json');
    git(root, 'commit', '-qm', 'no lock');
    writeFileSync(lock, before);
    expect((await checked(args)).names).toHaveLength(NAMES.length);
  });

  it('checks what differs from the last commit on the default branch: changed, staged, renamed, new; not what is deleted', async () => {
    expect(await checked(['--changed'])).toMatchObject({
      code: 0,
      names: [],
      stderr: expect.stringMatching(/^no level has changed since main \(merge base [0-9a-f]{7}\)\n$/),
    });
    write('a');
    write("odd 'né' $(x)");
    write('new\nline');
    renameSync(join(game, 'levels/c.level.json'), join(game, 'levels/z.level.json'));
    git(root, 'add', '-A');
    write('sub/untracked');
    rmSync(join(game, 'levels/b.level.json'));
    const { names, stderr } = await checked(['--changed']);
    expect(names).toEqual(['a', 'new\nline', "odd 'né' $(x)", 'sub/untracked', 'z']);
    expect(stderr).toMatch(/^5 of 6 levels changed since main/);
  });

  it('compares with the point where the branch has left, not with what has come since', async () => {
    git(root, 'checkout', '-qb', 'topic');
    write('b');
    commit(root);
    git(root, 'checkout', '-q', 'main');
    write('c');
    commit(root);
    git(root, 'checkout', '-q', 'topic');
    write('a');
    for (const args of [['--changed'], ['--changed', 'main'], ['--changed=main']])
      expect((await checked(args)).names).toEqual(['a', 'b']);
    expect((await checked(['--changed=HEAD'])).names).toEqual(['a']);
    expect((await checked(['--changed=HEAD~1'])).names).toEqual(['a', 'b']);
    // GitHub names the branch into which a pull request goes
    git(root, 'branch', 'release', 'topic');
    const env = { GITHUB_BASE_REF: 'release' };
    const { stderr } = await gq(['check', '--changed'], { cwd: game, env });
    expect(stderr).toMatch(/^1 of 5 levels changed since release/);
    const missing = await gq(['check', '--changed'], { cwd: game, env: { GITHUB_BASE_REF: 'gone' } });
    expect(missing).toMatchObject({ code: 2, stderr: expect.stringMatching(/branch gone, into which .*git fetch origin gone/) });
  });

  it('finds the same files whatever the working directory, the paths and the settings of git', async () => {
    write('sub/d');
    git(root, 'config', 'diff.relative', 'true');
    git(root, 'config', 'diff.noprefix', 'true');
    git(root, 'config', 'diff.external', 'false');
    expect((await checked(['.', '--changed'], join(game, 'levels/sub'))).names).toEqual(['d']);
    expect((await checked(['game', '--changed'], root)).names).toEqual(['game/levels/sub/d']);
    expect((await checked(['levels/a.level.json', '--changed'])).names).toEqual([]);
    symlinkSync(game, join(root, 'link'));
    expect((await checked(['levels', '--changed'], join(root, 'link'))).names).toEqual(['sub/d']);
  });

  it('checks all levels when the configuration has changed, and says so', async () => {
    const path = join(root, 'gq.config.json');
    for (const isThere of [true, false]) {
      if (isThere) writeFileSync(path, '{}');
      else {
        commit(root);
        rmSync(path);
      }
      const { names, stderr } = await checked(['--changed']);
      expect(names).toHaveLength(NAMES.length);
      expect(stderr).toMatch(/^all 5 levels checked: gq\.config\.json has changed since main/);
    }
  });

  it('fails as ever for a level that has changed and is broken, and for a path that matches nothing', async () => {
    write('a', '{');
    expect(await checked(['--changed'])).toMatchObject({ code: 1, names: ['a'] });
    expect(await checked(['nowhere', '--changed'])).toMatchObject({ code: 2, stderr: expect.stringContaining('nowhere') });
  });

  it('takes every level for new before the first commit, and in a repository inside', async () => {
    const inside = join(game, 'levels/inside');
    mkdirSync(inside);
    git(inside, 'init', '-q');
    writeFileSync(join(inside, 'x.level.json'), fallThrough());
    expect((await checked(['--changed'])).names).toEqual(['inside/x']);
    const { names, stderr } = await checked(['.', '--changed'], inside);
    expect([names, stderr]).toEqual([['x'], '1 of 1 level changed since the beginning, as there is no commit yet\n']);
  });

  it.each([
    [['--changed', 'nothing'], /there is no commit of that name: expected a branch, a tag or a commit/],
    [['--changed', 'levels'], /no commit of that name, but a path: .*gq check levels --changed, or --changed=REF levels/],
    [['--changed=--output=x'], /there is no commit of that name/],
    [['--changed='], /there is no commit of that name/],
    [['-', '--changed'], /expected no level from standard input/],
  ])('%j ends with 2 and says why', async (args, message) => {
    expect(await checked(args)).toMatchObject({ code: 2, stderr: expect.stringMatching(message) });
  });

  it('says what to do in a shallow clone, without a repository and without git', async () => {
    write('a');
    git(root, 'checkout', '-qb', 'topic');
    commit(root);
    const clone = makeFiles({});
    removals.push(clone.remove);
    git(clone.directory, 'clone', '-q', '--depth', '1', '--no-single-branch', `file://${root}`, 'clone');
    const shallow = await checked(['--changed', 'origin/main'], join(clone.directory, 'clone/game'));
    expect(shallow).toMatchObject({
      code: 2,
      stderr: expect.stringMatching(/no common commit: this clone is shallow.*fetch-depth: 0/),
    });
    const unknown = await checked(['--changed', 'v1.0'], join(clone.directory, 'clone/game'));
    expect(unknown.stderr).toMatch(/no commit of that name; this clone is shallow/);

    const { directory, remove } = makeFiles({ 'levels/a.level.json': fallThrough() });
    removals.push(remove);
    expect(await checked(['--changed'], directory)).toMatchObject({
      code: 2,
      stderr: expect.stringMatching(/this is not a git repository: expected a working directory in one/),
    });
    const noGit = await gq(['check', '--changed'], { cwd: game, env: { PATH: directory } });
    expect(noGit).toMatchObject({ code: 2, stdout: '', stderr: expect.stringContaining('there is no command git') });
  });
});

describe('a level from standard input', () => {
  const run = (args: readonly string[], input: string | Uint8Array) => gq(args, { cwd: game, input });
  const runPiped = (args: readonly string[], input: string | Uint8Array) =>
    gqProcess(args, {
      cwd: game,
      during: (child) => {
        child.stdin?.on('error', () => {});
        child.stdin?.end(input);
      },
    });

  it('is checked and formatted as its file would be', async () => {
    const text = fallThrough({ runs: [] });
    write('a', text);
    const fromFile = await gq(['check', 'levels/a.level.json'], { cwd: game });
    expect(await runPiped(['check', '-', '--stdin-path', 'levels/a.level.json'], text)).toEqual(fromFile);
    const unnamed = await run(['check', '-'], text);
    expect(unnamed.stdout).toBe(
      fromFile.stdout
        .replace(/\n {4}look at it: .*/, '')
        .replaceAll('levels/a.level.json', '<stdin>')
        .replace(/(gq solve )<stdin>/, '$1"<stdin>"'),
    );
    const formatted = await runPiped(['fmt', '-'], text);
    await gq(['fmt', 'levels/a.level.json'], { cwd: game });
    expect(formatted).toMatchObject({ code: 0, stderr: '', stdout: readFileSync(join(game, 'levels/a.level.json'), 'utf8') });
    expect(await run(['fmt', '-', '--check'], formatted.stdout)).toMatchObject({ code: 0, stdout: '', stderr: '' });
    expect(await run(['fmt', '-', '--check'], text)).toMatchObject({ code: 1, stdout: '', stderr: '<stdin>: would change\n' });
  });

  it('is refused like a file: empty, too large, not UTF-8', async () => {
    const inputs: [string | Uint8Array, RegExp][] = [
      ['', /empty-file/],
      [new Uint8Array(9 * 1024 * 1024).fill(32), /file-too-large/],
      [Buffer.from([0x7b, 0xff]), /not-utf8/],
    ];
    for (const [input, code] of inputs) {
      const [check, fmt] = await Promise.all([run(['check', '-'], input), run(['fmt', '-'], input)]);
      expect([check.code, fmt.code]).toEqual([1, 1]);
      expect(check.stdout).toMatch(code);
      expect(fmt.stderr).toMatch(code);
      expect(fmt.stdout).toBe('');
    }
  });

  it('stands alone', async () => {
    for (const [args, message] of [
      [['check', '-', 'levels'], /expected no other path/],
      [['check', '--stdin-path', 'a'], /expected the path - with it/],
      [['check', '-', '--update-lock'], /--update-lock records files/],
      [['check', '-', '--lock', 'x'], /expected --stdin-path FILE/],
      [['fmt', '-', '--format', 'json'], /standard output gets the formatted text/],
    ] as const)
      expect(await gq(args, { cwd: game })).toMatchObject({ code: 2, stdout: '', stderr: expect.stringMatching(message) });
  });

  it.runIf(process.platform === 'linux')('is not awaited from a terminal', () => {
    const script = join(root, 'run.sh');
    writeFileSync(
      script,
      `#!/bin/sh\nexec "${process.execPath}" "${new URL('../../dist/gq/main.js', import.meta.url).pathname}" check -\n`,
    );
    chmodSync(script, 0o755);
    const ended = spawnSync('script', ['-qec', script, '/dev/null'], {
      cwd: game,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    expect(ended.status).toBe(2);
    expect(ended.stdout).toContain('standard input is a terminal');
  });
});
