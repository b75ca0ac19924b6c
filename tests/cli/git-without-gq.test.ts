import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { someOf } from '../depth.ts';
import { GIT_ENVIRONMENT } from './git-environment.ts';
import { gq, makeFiles } from './gq.ts';

// git takes any small exit code of a merge driver for a conflict in a file that holds both sides. A gq that can't start leaves
// our version only: whoever commits it loses theirs without a word.

const FILE = "levels/it's ä 50%.level.json";
const level = (name: string, radius: number) =>
  `{\n  "version": 1,\n  "name": "${name}",\n  "astronaut": { "x": 0, "y": 0 },\n  "blackHole": { "x": 0, "y": 200 },\n\n\n\n\n\n  "asteroids": [\n    { "id": "aa", "x": 0, "y": 100, "radius": ${radius} }\n  ]\n}\n`;

let folder: ReturnType<typeof makeFiles>;
const run = (...args: string[]) => {
  const { status, stdout, stderr } = spawnSync('git', args, { cwd: folder.directory, env: GIT_ENVIRONMENT, encoding: 'utf8' });
  return { status, said: stdout + stderr };
};
const git = (...args: string[]): string => {
  const { status, said } = run(...args);
  if (status !== 0) throw new Error(`git ${args.join(' ')}: ${said}`);
  return said.trim();
};
const text = () => readFileSync(join(folder.directory, FILE), 'utf8');
const commit = (content: string) => {
  writeFileSync(join(folder.directory, FILE), content);
  git('add', '-A');
  git('commit', '-qm', 'change');
};

/** What is put where gq was, and what remains of it. */
const REPLACEMENTS = [
  ['gq is gone', null],
  ['gq is too old for the command', 'process.exitCode = 2;'],
] as const;

describe.each(someOf(REPLACEMENTS, 1))('git, set up by gq git-setup, when %s', (_, script) => {
  beforeEach(async () => {
    folder = makeFiles({ [FILE]: level('base', 16), ...(script !== null && { 'other.cjs': script }) });
    git('init', '-qb', 'main');
    expect((await gq(['git-setup'], { cwd: folder.directory })).code).toBe(0);
    git('add', '-A');
    git('commit', '-qm', 'base');
    for (const key of ['merge.gq-level.driver', 'diff.gq-level.textconv']) {
      const command = git('config', key);
      const moved = command.replace(/'[^']*main\.js'/g, `'${script === null ? '/nowhere/main.js' : 'other.cjs'}'`);
      expect(moved).not.toBe(command);
      git('config', key, moved);
    }
  });
  afterEach(() => folder.remove());

  const fork = (ours: string, theirs: string) => {
    git('checkout', '-qb', 'other');
    commit(theirs);
    git('checkout', '-q', 'main');
    commit(ours);
    return run('merge', '--no-edit', 'other');
  };

  it('merges as text and says so: what both changed has the marks of git', () => {
    const { status, said } = fork(level('ours', 16), level('theirs', 16));
    expect(status).toBe(1);
    expect(said).toContain(`${FILE}: merged as text`);
    expect(said).toContain('gq git-setup');
    expect(text()).toContain('<<<<<<< ours\n  "name": "ours",\n=======\n  "name": "theirs",\n>>>>>>> theirs\n');
  });

  it('merges as text and says so: what is apart is taken', () => {
    const { status, said } = fork(level('ours', 16), level('base', 20));
    expect(status).toBe(0);
    expect(said).toContain(`${FILE}: merged as text`);
    expect(text()).toBe(level('ours', 20));
  });

  it('still shows what changed', () => {
    writeFileSync(join(folder.directory, FILE), level('base', 20));
    const { status, said } = run('diff');
    expect(status).toBe(0);
    expect(said).toContain('+    { "id": "aa", "x": 0, "y": 100, "radius": 20 }');
  });
});
