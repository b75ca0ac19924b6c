import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { GIT_ENVIRONMENT } from './git-environment.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const FILE = 'levels/ü x.level.json';
const named = (name: string): string => JSON.stringify({ ...JSON.parse(fallThrough()), name });

describe('gq diff while git has conflicts in a level', () => {
  let folder: ReturnType<typeof makeFiles>;
  const git = (...args: string[]) => spawnSync('git', args, { cwd: folder.directory, env: GIT_ENVIRONMENT, encoding: 'utf8' });
  const commit = (name: string) => {
    writeFileSync(join(folder.directory, FILE), named(name));
    git('add', '-A');
    expect(git('commit', '-qm', name).status).toBe(0);
  };
  beforeEach(() => {
    folder = makeFiles({ [FILE]: named('base') });
    git('init', '-qb', 'main');
    commit('base');
    git('checkout', '-qb', 'other');
    commit('theirs');
    git('checkout', '-q', 'main');
    commit('ours');
    expect(git('merge', 'other').status).toBe(1);
  });
  afterEach(() => folder.remove());

  it('shows what is on disk for the working tree, and says why there is nothing staged to compare', async () => {
    const diff = (...args: string[]) => gq(['diff', '--no-slack', ...args], { cwd: folder.directory });
    expect((await diff()).stdout).toMatch(/^~ levels\/ü x\.level\.json .*\n {4}after: .*:1:1: /);
    const staged = await diff('--staged');
    expect(staged).toMatchObject({ code: 0, stdout: 'HEAD -> the index: no level changed\n' });
    expect(staged.stderr).toContain(`${FILE} is not compared: git has conflicts in it`);
    git('checkout', '--theirs', '.');
    git('add', '-A');
    expect((await diff('--staged')).stdout).toContain('renamed "ours" -> "theirs"');
  });
});
