import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect } from 'vitest';
import { itQuick as it, itDeep } from '../depth.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';

// she falls through the asteroid with any pull, and sooner with a stronger one
const level = (rules?: object) => fallThrough(rules === undefined ? {} : { rules });

const FILES = {
  '.git/HEAD': '',
  'gq.config.json': '{ "levels": ["somewhere"], "rules": { "pull": 100, "boxHeight": 40 } }',
  'levels/plain.level.json': level(),
  'levels/usual.level.json': level({ pull: 39 }),
  'levels/deep/strong.level.json': level({ pull: 200 }),
  // another repository, without its own configuration
  'other/.git/HEAD': '',
  'other/plain.level.json': level(),
};

let files: ReturnType<typeof makeFiles>;
beforeAll(() => {
  files = makeFiles(FILES);
});
afterAll(() => files.remove());

const run = (args: string, folder = '.') => gq(args.split(' '), { cwd: join(files.directory, folder) });
const hashOf = async (args: string, folder = '.'): Promise<string> => {
  const { stdout, stderr } = await run(`simulate ${args} --format json`, folder);
  expect(stderr).toBe('');
  return JSON.parse(stdout).hash;
};

describe('rules of gq.config.json', () => {
  it('apply to levels that do not set them, key by key, from any folder of the repository', async () => {
    const said = makeFiles({
      'both.level.json': level({ pull: 100, boxHeight: 40 }),
      'box.level.json': level({ boxHeight: 40 }),
      'own.level.json': level(),
    });
    try {
      const there = (name: string) => join(said.directory, name);
      const outside = async (name: string): Promise<string> => {
        const { stdout } = await gq(['simulate', there(name), '--format', 'json'], { cwd: said.directory });
        return JSON.parse(stdout).hash;
      };
      const both = await outside('both.level.json');
      expect(await outside('own.level.json')).not.toBe(both);
      expect(await hashOf('levels/plain.level.json')).toBe(both);
      expect(await hashOf('plain.level.json', 'levels')).toBe(both);
      expect(await hashOf('../plain.level.json', 'levels/deep')).toBe(both);
      expect(await hashOf('levels/usual.level.json')).toBe(await outside('box.level.json'));
      // the working directory counts, not the folder of the file
      expect(await hashOf('plain.level.json', 'other')).toBe(await outside('own.level.json'));
    } finally {
      said.remove();
    }
  });

  itDeep('also apply in check, difficulty, inspect, accuracy, solve and render', async () => {
    const reports = async (args: string, folder?: string) =>
      (await run(args, folder)).stdout.replace(/"(ms|cost|seconds)":[\d.e-]+/g, '');
    const same = async (args: (file: string) => string) => {
      const here = await reports(args('levels/plain.level.json'));
      expect(here.length).toBeGreaterThan(0);
      expect(await reports(args('plain.level.json'), 'other')).not.toBe(here);
    };
    await same((file) => `check ${file} --format json`);
    await same((file) => `difficulty ${file} --jobs 1 --format json`);
    await same((file) => `inspect ${file} --accuracy arcade --format json`);
    await same((file) => `solve ${file} --objective first --effort 10000 --jobs 1 --format json`);
    await same((file) => `render ${file} -o -`);
  });

  it('are not written to files by fmt', async () => {
    const before = await run('fmt levels/plain.level.json');
    expect(before.code).toBe(0);
    const { stdout } = await run('check levels --format json');
    expect(JSON.parse(stdout).summary.completable).toBe(3);
    expect(await hashOf('levels/plain.level.json')).not.toBe(await hashOf('levels/usual.level.json'));
  });

  it('do not make gq edit print anything at its start: its page uses them', async () => {
    const { stdout, code } = await gqProcess(['edit', 'levels', '--port', '0'], {
      cwd: files.directory,
      during: (child) => child.stdout?.once('data', () => child.kill('SIGTERM')),
    });
    expect(code).toBe(143);
    expect(stdout).toMatch(/^Editing levels at\n/);
  });

  it.each([
    ['{ "rules": { "pul": 3 } }', ':1:14', 'did you mean "pull"?'],
    ['{\n  "rules": { "push": "20" }\n}', ':2:22', 'Remove the quotes'],
    ['{ "rules": { "pull": 4000 } }', ':1:22', 'at most 1000'],
    ['{ "rules": [] }', ':1:12', 'expected an object'],
    ['[]', ':1:1', 'expected the configuration of a folder'],
    ['{ "rules": { "pull": 3 }', ':1:', 'error'],
  ])('are errors with a place if they are invalid: %s', async (config, place, words) => {
    const wrong = makeFiles({ 'gq.config.json': config, 'a.level.json': level() });
    try {
      for (const args of [
        ['check', '.'],
        ['simulate', 'a.level.json'],
        ['difficulty', '.'],
        ['generate', '--out', 'made'],
        ['edit', '.', '--port', '0'],
      ]) {
        const { code, stdout, stderr } = await gq(args, { cwd: wrong.directory });
        expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
        expect(stderr).toContain(`gq.config.json${place}`);
        expect(stderr).toContain(words);
      }
    } finally {
      wrong.remove();
    }
  });
});
