import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import { itQuick, someOf } from '../depth.ts';
import { once } from '../once.ts';
import { GIT_ENVIRONMENT } from './git-environment.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

// Each test imitates the job of a service: a clone as its checkout makes it, and the variables that it sets.

const removals: (() => void)[] = [];
afterAll(() => {
  for (const remove of removals) remove();
});

const NAMES = ['a', 'b', 'c'];
const ZEROS = '0'.repeat(40);

const git = (cwd: string, ...args: string[]): string =>
  execFileSync('git', args, { cwd, encoding: 'utf8', stdio: 'pipe', env: GIT_ENVIRONMENT }).trim();

/** A folder with `work`, whose `main` has two commits, and `origin`, to which it has pushed. */
const original = once((): string => {
  const { directory, remove } = makeFiles(
    Object.fromEntries(NAMES.map((name) => [`work/levels/${name}.level.json`, fallThrough({ name })])),
  );
  removals.push(remove);
  const work = join(directory, 'work');
  git(directory, 'init', '-q', '--bare', '-b', 'main', '--template=', 'origin');
  git(work, 'init', '-q', '-b', 'main', '--template=');
  git(work, 'remote', 'add', 'origin', '../origin');
  push(work);
  return directory;
});

let place = '';
let work = '';
beforeEach(() => {
  const made = makeFiles({});
  removals.push(made.remove);
  place = made.directory;
  cpSync(original(), place, { recursive: true });
  work = join(place, 'work');
});

/** Commits all that is there and pushes the branch. @returns the commit */
function push(folder: string, ...options: string[]): string {
  git(folder, 'add', '-A');
  git(folder, 'commit', '-qm', 'commit', '--allow-empty');
  git(folder, 'push', '-q', ...options, 'origin', 'HEAD');
  return git(folder, 'rev-parse', 'HEAD');
}

const write = (...names: string[]): void => {
  for (const name of names) writeFileSync(join(work, `levels/${name}.level.json`), fallThrough({ name: `new ${name}` }));
};

const head = (): string => git(work, 'rev-parse', 'HEAD');

/** Clones as actions/checkout does it for a push: one ref, detached or not, with some depth; 0: the whole history of all branches. */
function checkout(branch: string, depth: number): string {
  const folder = join(place, 'job');
  const options = depth === 0 ? [] : ['--depth', String(depth)];
  git(place, 'clone', '-q', '-b', branch, ...options, `file://${join(place, 'origin')}`, folder);
  return folder;
}

interface Checked {
  readonly code: number | null;
  readonly stderr: string;
  /** null: nothing was checked, as the code is 2. */
  readonly names: readonly string[] | null;
}

async function check(folder: string, env: Readonly<Record<string, string>>, args = ['--changed']): Promise<Checked> {
  const { code, stdout, stderr } = await gq(['check', ...args, '--format', 'json'], { cwd: folder, env });
  if (code === 2) return { code, stderr, names: null };
  const { levels } = JSON.parse(stdout) as { levels: { file: string }[] };
  return { code, stderr, names: levels.map(({ file }) => file.replace(/^levels\/|\.level\.json$/g, '')) };
}

/** The variables of a job on GitHub, whose event is in a file. */
function onGithub(event: object, more: Readonly<Record<string, string>> = {}): Record<string, string> {
  const path = join(place, 'event.json');
  writeFileSync(path, JSON.stringify({ repository: { default_branch: 'main' }, ...event }));
  return { CI: 'true', GITHUB_ACTIONS: 'true', GITHUB_EVENT_PATH: path, GITHUB_BASE_REF: '', ...more };
}

/** The variables of a pipeline on GitLab. */
const onGitlab = (more: Readonly<Record<string, string>>): Record<string, string> => ({
  CI: 'true',
  GITLAB_CI: 'true',
  CI_DEFAULT_BRANCH: 'main',
  CI_COMMIT_BEFORE_SHA: ZEROS,
  ...more,
});

/** A push onto a branch, as both services tell it. */
const PUSHED: [string, (before: string, branch?: string) => Record<string, string>][] = [
  ['GitHub', (before, branch = 'main') => onGithub({ before, ref: `refs/heads/${branch}` })],
  ['GitLab', (before, branch = 'main') => onGitlab({ CI_COMMIT_BEFORE_SHA: before, CI_COMMIT_BRANCH: branch })],
];

describe.each(someOf(PUSHED, 1))('gq check --changed on %s, for a push', (_, pushed) => {
  it('checks what all its commits have changed, though the branch of the remote is where they end', async () => {
    const before = head();
    write('a');
    push(work);
    write('b');
    push(work);
    const { names, stderr } = await check(checkout('main', 0), pushed(before));
    expect(names).toEqual(['a', 'b']);
    expect(stderr).toBe(`2 of 3 levels changed since the last push (${before.slice(0, 7)})\n`);
  });

  it('ends with 2 where the clone ends before it, and says what to do', async () => {
    const before = head();
    write('a');
    push(work);
    const { code, stderr } = await check(checkout('main', 1), pushed(before));
    expect(code).toBe(2);
    expect(stderr).toMatch(
      /^error: --changed: the commit before this push, [0-9a-f]{7}, is not there: this clone is shallow.*git fetch --unshallow.*fetch-depth: 0.*GIT_DEPTH: 0/,
    );
    // where its depth is enough, it does not matter that it is shallow
    rmSync(join(place, 'job'), { recursive: true });
    expect((await check(checkout('main', 2), pushed(before))).names).toEqual(['a']);
  });

  itQuick('checks what a merge brings, renamed files too, and nothing for deleted ones', async () => {
    const before = head();
    git(work, 'checkout', '-qb', 'topic');
    write('a');
    push(work);
    git(work, 'checkout', '-q', 'main');
    renameSync(join(work, 'levels/c.level.json'), join(work, 'levels/z.level.json'));
    push(work);
    git(work, 'merge', '-q', '--no-ff', '-m', 'merge', 'topic');
    push(work);
    expect((await check(checkout('main', 0), pushed(before))).names).toEqual(['a', 'z']);
    rmSync(join(place, 'job'), { recursive: true });
    const merged = head();
    rmSync(join(work, 'levels/b.level.json'));
    push(work);
    expect(await check(checkout('main', 0), pushed(merged))).toMatchObject({ code: 0, names: [] });
  });

  itQuick('compares with what a forced push has left, or checks all where that is gone', async () => {
    write('a');
    const left = push(work);
    git(work, 'reset', '-q', '--hard', 'HEAD~1');
    write('b');
    push(work, '--force');
    const job = checkout('main', 0);
    const gone = await check(job, pushed(left));
    expect(gone.names).toEqual(NAMES);
    expect(gone.stderr).toBe(
      `all 3 levels checked: the commit before this push, ${left.slice(0, 7)}, is gone, as after a forced push\n`,
    );
    // `a` is as it was at first, and not as it was checked last
    git(job, 'fetch', '-q', work, `${left}:refs/heads/left`);
    expect((await check(job, pushed(left))).names).toEqual(['a', 'b']);
  });

  itQuick('compares a new branch with the default branch, or checks all where that says nothing', async () => {
    git(work, 'checkout', '-qb', 'topic');
    const empty = push(work);
    expect(empty).not.toBe('');
    write('b');
    push(work);
    expect((await check(checkout('topic', 0), pushed(ZEROS, 'topic'))).names).toEqual(['b']);
    rmSync(join(place, 'job'), { recursive: true });
    // as GitLab clones it: without other branches
    const shallow = await check(checkout('topic', 1), pushed(ZEROS, 'topic'));
    expect(shallow).toMatchObject({ code: 0, names: NAMES, stderr: expect.stringContaining('all 3 levels checked: ') });
    rmSync(join(place, 'job'), { recursive: true });
    // the first push of the default branch
    expect((await check(checkout('main', 0), pushed(ZEROS))).names).toEqual(NAMES);
    // a branch that begins where main is
    git(work, 'push', '-q', 'origin', 'main:again');
    rmSync(join(place, 'job'), { recursive: true });
    const again = await check(checkout('again', 0), pushed(ZEROS, 'again'));
    expect(again.names).toEqual(NAMES);
    expect(again.stderr).toBe(
      'all 3 levels checked: nothing tells what has changed: origin/main has the commit that is checked out\n',
    );
  });

  it('a level that it breaks makes it fail', async () => {
    const before = head();
    writeFileSync(join(work, 'levels/a.level.json'), '{');
    push(work);
    expect(await check(checkout('main', 0), pushed(before))).toMatchObject({ code: 1, names: ['a'] });
  });
});

describe('gq check --changed in a job', () => {
  it.each([
    ['a tag', () => onGithub({ before: ZEROS, ref: 'refs/tags/v1' })],
    ['a tag on GitLab', () => onGitlab({ CI_COMMIT_TAG: 'v1' })],
    ['a schedule', () => onGithub({ schedule: '0 0 * * *' })],
    ['an event that can not be read', () => ({ CI: 'true', GITHUB_EVENT_PATH: join(place, 'nowhere.json') })],
    ['an event that is none', () => onGithub({ before: '--output=x', ref: 7 })],
    ['another service', () => ({ CI: 'true' })],
    ['a service that does not set CI', () => ({ TF_BUILD: 'True' })],
  ])('checks all and says so where nothing tells what has changed: %s', async (_, env) => {
    write('a');
    push(work);
    const { names, stderr } = await check(checkout('main', 0), env());
    expect(names).toEqual(NAMES);
    expect(stderr).toMatch(/^all 3 levels checked: \S.*\n$/);
  });

  itQuick('checks all in a shallow clone whose branch is that of the remote, whatever runs it', async () => {
    write('a');
    push(work);
    const job = checkout('main', 1);
    expect(await check(job, {})).toMatchObject({ code: 0, names: NAMES });
    expect(await check(job, {}, ['--changed=origin/main'])).toMatchObject({ code: 0, names: NAMES });
    // who asks for what is not committed gets that
    expect(await check(job, { CI: 'true' }, ['--changed=HEAD'])).toMatchObject({ code: 0, names: [] });
    // a working directory of a person
    rmSync(job, { recursive: true });
    expect(await check(checkout('main', 0), {})).toMatchObject({ code: 0, names: [] });
  });

  itQuick('compares a pull request with the branch into which it goes', async () => {
    git(work, 'checkout', '-qb', 'topic');
    write('a');
    const last = push(work);
    git(work, 'checkout', '-q', 'main');
    write('b');
    const base = push(work);
    // GitHub checks out a merge of both, which is on no branch; a pull request of a fork looks the same
    git(work, 'merge', '-q', '--no-ff', '-m', 'merge', 'topic');
    git(work, 'push', '-q', 'origin', 'HEAD:refs/pull/1/merge');
    const event = { action: 'synchronize', before: last, after: last, pull_request: { base: { ref: 'main', sha: base } } };
    const job = join(place, 'job');
    const fetch = (...options: string[]): void => {
      rmSync(job, { recursive: true, force: true });
      mkdirSync(job);
      git(job, 'init', '-q', '--template=');
      git(job, 'remote', 'add', 'origin', `file://${join(place, 'origin')}`);
      git(job, 'fetch', '-q', ...options);
      git(job, 'checkout', '-q', '--detach', 'refs/remotes/pull/1/merge');
    };
    const merge = '+refs/pull/1/merge:refs/remotes/pull/1/merge';
    fetch('origin', merge, '+refs/heads/*:refs/remotes/origin/*');
    const env = onGithub(event, { GITHUB_BASE_REF: 'main' });
    expect((await check(job, env)).names).toEqual(['a']);
    // the commit alone
    fetch('origin', merge);
    expect((await check(job, env)).names).toEqual(['a']);
    fetch('--depth', '1', 'origin', merge);
    expect(await check(job, env)).toMatchObject({
      code: 2,
      stderr: expect.stringMatching(/the branch main, into which this pull request goes, is not there: this clone is shallow/),
    });
    // pull_request_target checks out the branch into which it goes
    rmSync(job, { recursive: true });
    expect((await check(checkout('main', 0), env)).names).toEqual(NAMES);
  });

  itQuick('compares a merge request with the commit that GitLab names, else with its branch', async () => {
    const base = head();
    git(work, 'checkout', '-qb', 'topic');
    write('a');
    push(work);
    write('c');
    push(work);
    const request = { CI_MERGE_REQUEST_TARGET_BRANCH_NAME: 'main', CI_MERGE_REQUEST_DIFF_BASE_SHA: base };
    // 3 commits, and no other branch
    expect((await check(checkout('topic', 3), onGitlab(request))).names).toEqual(['a', 'c']);
    rmSync(join(place, 'job'), { recursive: true });
    expect(await check(checkout('topic', 2), onGitlab(request))).toMatchObject({
      code: 2,
      stderr: expect.stringMatching(/GIT_DEPTH: 0/),
    });
    rmSync(join(place, 'job'), { recursive: true });
    expect((await check(checkout('topic', 0), onGitlab({ ...request, CI_MERGE_REQUEST_DIFF_BASE_SHA: '' }))).names).toEqual([
      'a',
      'c',
    ]);
  });
});
