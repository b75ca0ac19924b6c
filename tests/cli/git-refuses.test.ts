import { execFileSync } from 'node:child_process';
import { chownSync } from 'node:fs';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { GIT_ENVIRONMENT } from './git-environment.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

let place: ReturnType<typeof makeFiles>;
let bare: ReturnType<typeof makeFiles>;
beforeAll(() => {
  place = makeFiles({ 'levels/a.level.json': fallThrough() });
  bare = makeFiles({});
  execFileSync('git', ['init', '-q', '--template='], { cwd: place.directory, env: GIT_ENVIRONMENT });
  execFileSync('git', ['init', '-q', '--bare', '--template='], { cwd: bare.directory, env: GIT_ENVIRONMENT });
});
afterAll(() => {
  place.remove();
  bare.remove();
});

const COMMANDS = [['check', '--changed'], ['diff'], ['diff', 'main'], ['git-setup'], ['git-setup', '--check']];

// as in a container whose user is not the owner of the files
describe.each(COMMANDS)('gq %s %s in a repository of another owner', (...args) => {
  const env = { GIT_CONFIG_GLOBAL: '/dev/null', GIT_CONFIG_SYSTEM: '/dev/null' };
  const command = args.filter((word) => word !== undefined);

  const expectOwnWords = async (more: Readonly<Record<string, string>>): Promise<void> => {
    const { code, stderr } = await gq(command, { cwd: place.directory, env: { ...env, ...more } });
    expect(code).toBe(2);
    expect(stderr).toMatch(/asks git, which refuses to work here: detected dubious ownership in repository at /);
    // what to do, which git says itself
    expect(stderr).toContain('git config --global --add safe.directory');
    expect(stderr).not.toContain('not a git repository');
  };

  it("shows git's own words, and its remedy", () => expectOwnWords({ GIT_TEST_ASSUME_DIFFERENT_OWNER: '1' }));

  it.runIf(process.getuid?.() === 0)('the same, where it really is of another', async () => {
    chownSync(place.directory, 54321, 54321);
    chownSync(`${place.directory}/.git`, 54321, 54321);
    try {
      await expectOwnWords({});
    } finally {
      chownSync(place.directory, 0, 0);
      chownSync(`${place.directory}/.git`, 0, 0);
    }
  });
});

it.each(COMMANDS)('gq %s %s says that a bare repository has no files', async (...args) => {
  const command = args.filter((word) => word !== undefined);
  const { code, stderr } = await gq(command, { cwd: bare.directory });
  expect({ code, stderr }).toEqual({ code: 2, stderr: expect.stringMatching(/expected a (working tree|path)|matches no level/) });
});

it.each(COMMANDS)('gq %s %s says what to do without git', async (...args) => {
  const command = args.filter((word) => word !== undefined);
  const { code, stderr } = await gq(command, { cwd: place.directory, env: { PATH: bare.directory } });
  expect({ code, stderr }).toEqual({
    code: 2,
    stderr: expect.stringMatching(/asks git, and there is no command git: expected it in PATH: install it first, or /),
  });
});
