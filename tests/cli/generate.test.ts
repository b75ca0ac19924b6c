import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect } from 'vitest';
import { generatedPath, keepLevel, packPath } from '../../cli/generate/index.ts';
import { formatLevel, generateReportSchema, type LevelFile } from '../../schema/index.ts';
import type { Generated } from '../../solver/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { interruptAt } from '../interrupted/step.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';
import { inDirectory } from './levels.ts';

const { directory: cwd, remove } = makeFiles({ 'kept/none': '' });
afterAll(remove);

const generate = (args: string, run = gq) => run(['generate', ...args.split(' ')], { cwd });

describeQuick('a generated level', () => {
  const level = JSON.parse(fallThrough({ name: 'Gentle Bend!' })) as LevelFile;
  const made = { level } as Generated;
  const directory = join(cwd, 'kept');

  it('has a file named after it and its seed', () => {
    expect(generatedPath('out', level.name, 7)).toBe(join('out', 'gentle-bend-7.level.json'));
  });

  it('has a number in a pack, with as many digits as the last level of it', () => {
    expect(packPath('out', level.name, 3, 8)).toBe(join('out', '03-gentle-bend.level.json'));
    expect(packPath('out', level.name, 3, 120)).toBe(join('out', '003-gentle-bend.level.json'));
  });

  it('is written once, and never overwrites another file', () => {
    const path = generatedPath(directory, level.name, 7);
    expect(keepLevel(directory, path, made)).toBe('written');
    expect(inDirectory(directory, 'gentle-bend-7.level.json')).toBe(formatLevel(level));
    expect(keepLevel(directory, path, made)).toBe('unchanged');
    writeFileSync(path, 'precious');
    expect(keepLevel(directory, path, made)).toBe('in the way');
    expect(inDirectory(directory, 'gentle-bend-7.level.json')).toBe('precious');
    expect(readdirSync(directory).sort()).toEqual(['gentle-bend-7.level.json', 'none']);
  });
});

describe('gq generate', () => {
  const EASY = '--size small --difficulty 3 --ingredients none';

  it('refuses seeds past the largest one, and writes nothing and exits with 1 if no level is good enough', async () => {
    const last = 2 ** 32 - 1;
    const { code, stderr } = await generate(`--out past --seed ${last - 1} --count 3`);
    expect(code).toBe(2);
    expect(stderr).toContain(`--seed ${last - 1} --count 3: expected seeds up to ${last}, found up to ${last + 1}`);
    // the largest seed itself is allowed; nothing is written, since no level is good enough
    const { code: fits, stdout } = await generate(`--out past --seed ${last} ${EASY} --effort 1 --format json --jobs 1`);
    expect(fits).toBe(1);
    expect(JSON.parse(stdout).levels).toMatchObject([{ seed: last, status: 'nothing', file: null }]);
    expect(readdirSync(join(cwd, 'past'))).toEqual([]);
  });

  itDeep('writes levels that gq check and gq fmt pass, with winds and wormholes where they are asked for', async () => {
    const options = '--size medium --difficulty easy --ingredients winds,wormholes';
    const ended = await generate(`--out made --seed 15 ${options} --format json`);
    expect(ended).toMatchObject({ code: 0, stderr: '' });
    const { levels } = generateReportSchema.parse(JSON.parse(ended.stdout));
    expect(levels).toMatchObject([{ seed: 15, status: 'written' }]);
    const names = readdirSync(join(cwd, 'made'));
    expect(names.map((name) => `made/${name}`)).toEqual(levels.map(({ file }) => file));
    const level = JSON.parse(inDirectory(join(cwd, 'made'), names[0])) as LevelFile;
    expect((level.winds ?? level.wormholes)?.length).toBeGreaterThan(0);
    const [check, fmt] = await Promise.all([
      gq(['check', 'made', '--require-slack', '1'], { cwd }),
      gq(['fmt', '--check', 'made'], { cwd }),
    ]);
    expect([check.code, fmt.code]).toEqual([0, 0]);
    expect(check.stdout).not.toContain('warning');
  });

  itDeep('gives the same result for any number of threads', async () => {
    const args = `--out same --count 2 ${EASY} --effort 20000 --format json --jobs`;
    const ended = await Promise.all([generate(`${args} 1`), generate(`${args} 2`, gqProcess)]);
    expect(ended[1].stdout).toBe(ended[0].stdout);
    expect(JSON.parse(ended[0].stdout).levels.map(({ seed }: { seed: number }) => seed)).toEqual([0, 1]);
  });

  itDeep.runIf(process.platform === 'linux')(
    'ends on a signal without a report, and files that are already written are whole',
    async () => {
      const { code, stdout } = await gqProcess(
        'generate --out stopped --count 500 --difficulty hard --jobs 1 --format json'.split(' '),
        {
          cwd,
          // the signal arrives when the first thread starts
          env: interruptAt({ of: 'online', number: 1, signals: ['SIGINT'] }),
        },
      );
      expect(code).toBe(130);
      expect(stdout).toBe('');
      for (const name of readdirSync(join(cwd, 'stopped'))) expect(name).toMatch(/-\d+\.level\.json$/);
    },
  );

  itDeep('says of a pack which levels are missing, the same for any number of threads', async () => {
    const args = '--pack pack --count 3 --theme mixed --size small --difficulty easy --effort 3000 --format json --jobs';
    const ended = await Promise.all([generate(`${args} 1`), generate(`${args} 2`, gqProcess)]);
    expect(ended.map(({ code }) => code)).toEqual([1, 1]);
    expect(ended[1].stdout).toBe(ended[0].stdout);
    const { levels, asked } = generateReportSchema.parse(JSON.parse(ended[0].stdout));
    expect(asked).toBe(3);
    expect(levels.every(({ status }) => status === 'nothing')).toBe(true);
    // each was tried with four seeds
    expect(levels.every(({ attempts }) => attempts >= 4)).toBe(true);
    expect(readdirSync(join(cwd, 'pack'))).toEqual([]);
  });

  it.runIf(process.platform === 'linux')('reports before the work that the folder is not writable', async () => {
    const { code, stdout, stderr } = await generate('--out /proc/self --count 500 --difficulty hard');
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toMatch(
      /^error: --out \/proc\/self: no file can be created in it: .+; expected a directory that can be written\n$/,
    );
  });

  it.each([
    ['--count 1', 'expected either --out <dir>, for single levels, or --pack <dir>'],
    ['--out x --pack y', 'expected either --out <dir>, for single levels, or --pack <dir>'],
    ['--out x --theme caves', 'Allowed choices are orbits, corridors, slings, lures, fields, mixed'],
    ['--out x --theme mixed', '--theme mixed: expected --pack <dir> as well'],
    ['--out x --symmetry mirror', '--symmetry mirror: expected --theme as well'],
    ['--out x --tempting', '--tempting: expected --theme as well'],
    ['--out x --seed 4294967295 --count 3', 'expected seeds up to 4294967295, found up to 4294967297'],
    ['--out x --size huge', 'expected small, medium, large, or WIDTHxHEIGHT'],
    ['--out x --size 100x100', 'with sides of 360 to 4000 px'],
    ['--out x --difficulty 11', 'expected easy, medium, hard, or a grade from 1 to 10'],
    ['--out x --ingredients hot,cold', 'found "cold"'],
    [
      '--out x --ingredients winds,wormhole',
      'expected none, or some of hot, repulsors, aliens, recoil, wormholes, winds, separated by commas; found "wormhole"',
    ],
    ['--out kept/none/x', "the directory can't be created"],
  ])('%s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await generate(args);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });
});
