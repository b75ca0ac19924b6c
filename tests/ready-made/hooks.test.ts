import { chmodSync, copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, expect } from 'vitest';
import { parse } from 'yaml';
import { type Ended, fallThrough, gq } from '../cli/gq.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { makeProject, ofPackage, runIn } from './project.ts';

interface Hook {
  readonly id: string;
  readonly entry: string;
  readonly language: string;
  readonly files: string;
  readonly pass_filenames?: boolean;
}

const own: readonly Hook[] = parse(ofPackage('.pre-commit-hooks.yaml'));
const local: readonly Hook[] = parse(ofPackage('templates/pre-commit-config.yaml')).repos[0].hooks;
const lefthook = parse(ofPackage('templates/lefthook.yml'))['pre-commit'].commands as Record<
  string,
  { glob: string; run: string }
>;

const untidy = fallThrough();
const project = makeProject(
  {
    'levels/good.level.json': fallThrough(),
    'levels/my level.level.json': fallThrough(),
    'levels/bad.level.json': '{',
    'gq.config.json': '{}',
  },
  'real',
);
const { directory } = project;
afterAll(() => project.remove());

const STAGED = [
  'levels/good.level.json',
  'levels/my level.level.json',
  'levels/bad.level.json',
  'gq.config.json',
  'gq.lock.json',
  'readme.md',
];

/** Runs a command of gq that a template has, in the shared process. The git hook below runs one as it stands. */
function runGq(command: string, paths: readonly string[]): Promise<Ended> {
  const [, args] = /^(?:npx --no-install )?gq (.+)$/.exec(command) as RegExpExecArray;
  return gq([...args.split(' '), ...paths], { cwd: directory });
}

/** Runs a hook as pre-commit does: the words of its entry, then the staged files that match. */
function run({ entry, files, pass_filenames }: Hook, staged: readonly string[]) {
  const matching = staged.filter((file) => new RegExp(files).test(file));
  return runGq(entry, pass_filenames === false ? [] : matching);
}

describeQuick.each([
  ['of this package', own],
  ['that call the installed gq', local],
])('hooks for pre-commit %s', (_, hooks) => {
  const byId = (id: string): Hook => hooks.find((hook) => hook.id === id) as Hook;

  it('have what pre-commit asks for', () => {
    expect(hooks.map(({ id }) => id)).toEqual(['gq-check', 'gq-check-all', 'gq-fmt']);
    for (const { language } of hooks) expect(language).toBe(hooks === own ? 'node' : 'system');
  });

  it('check the staged levels and no other file', async () => {
    const good = await run(
      byId('gq-check'),
      STAGED.filter((file) => !file.includes('bad')),
    );
    expect(good.stdout).toContain('2 levels: 2 completable');
    expect(good.code).toBe(0);
    const bad = await run(byId('gq-check'), STAGED);
    expect(bad.code).toBe(1);
    expect(bad.stdout).toContain('levels/bad.level.json:1:2: error truncated-json');
  });

  it('check every level when what concerns all of them changes', async () => {
    const all = byId('gq-check-all');
    const matching = STAGED.filter((file) => new RegExp(all.files).test(file));
    expect(matching).toEqual(['gq.config.json', 'gq.lock.json']);
    expect((await run(all, STAGED)).stdout).toContain('3 levels: 2 completable, 1 invalid');
  });

  it('lay out the staged levels', async () => {
    writeFileSync(join(directory, 'levels/good.level.json'), untidy);
    expect((await run(byId('gq-fmt'), ['levels/good.level.json'])).code).toBe(0);
    expect(readFileSync(join(directory, 'levels/good.level.json'), 'utf8')).not.toBe(untidy);
    expect((await runGq('gq fmt', ['--check', 'levels/good.level.json'])).code).toBe(0);
  });
});

it('lefthook runs the same commands', async () => {
  for (const { glob, run } of Object.values(lefthook)) {
    expect(glob).toBe('*.level.json');
    expect((await runGq(run.replace('{staged_files}', 'levels/good.level.json'), [])).code).toBe(0);
  }
});

itDeep('the git hook lets a commit pass only if its levels do', () => {
  const git = (...args: string[]) =>
    runIn(directory, 'git', ['-c', 'user.name=a', '-c', 'user.email=a@example.org', '-c', 'core.hooksPath=.husky', ...args]);
  git('init', '-q');
  mkdirSync(join(directory, '.husky'));
  copyFileSync(fileURLToPath(new URL('../../templates/pre-commit', import.meta.url)), join(directory, '.husky/pre-commit'));
  chmodSync(join(directory, '.husky/pre-commit'), 0o755);
  git('add', 'gq.config.json');
  // nothing to check
  expect(git('commit', '-qm', 'configuration').status).toBe(0);
  git('add', 'levels/my level.level.json');
  expect(git('commit', '-qm', 'a level with a space in its name').status).toBe(0);
  git('add', 'levels/bad.level.json');
  const refused = git('commit', '-qm', 'bad');
  expect(refused.status).not.toBe(0);
  expect(refused.stdout + refused.stderr).toContain('levels/bad.level.json:1:2: error truncated-json');
  expect(git('log', '--format=%s').stdout).toBe('a level with a space in its name\nconfiguration\n');
});
