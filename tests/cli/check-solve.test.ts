import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { checkReportSchema, type LevelReport, readLevel } from '../../schema/index.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';
import { narrowGap, shipped, withoutRuns, withoutTimes } from './levels.ts';

const files = makeFiles({
  'a/away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 } }),
  'a/broken.level.json': fallThrough({ runs: [{ name: 'never', holds: [] }] }),
  'a/first-swing.level.json': withoutRuns('02-first-swing'),
  'a/good.level.json': fallThrough(),
  'a/needle.level.json': narrowGap(),
  'mineral.level.json': fallThrough({
    minerals: [
      { x: 50, y: 0 },
      { x: 400, y: 300 },
    ],
  }),
  'own.level.json': withoutRuns('02-first-swing'),
});
const cwd = files.directory;
afterAll(files.remove);

const check = async (args: string, run = gq): Promise<{ code: number | null; levels: LevelReport[]; stdout: string }> => {
  const { code, stdout, stderr } = await run(['check', ...args.split(' '), '--format', 'json'], { cwd });
  expect(stderr).toBe('');
  return { code, levels: checkReportSchema.parse(JSON.parse(stdout)).levels, stdout };
};
const verdicts = (levels: readonly LevelReport[]) => levels.map(({ name, verdict }) => `${name}: ${verdict}`);
const codesOf = ({ problems }: LevelReport) => problems.map(({ code, severity }) => `${severity} ${code}`);

describe('without --solve', () => {
  it('tries proofs, but no searches', async () => {
    const { code, levels } = await check('a');
    expect(code).toBe(1);
    expect(verdicts(levels)).toEqual([
      'Straight through: impossible',
      'Straight through: broken',
      'First Swing: unproven',
      'Straight through: completable',
      'Needle: unproven',
    ]);
    // a proved problem is not reported as a warning as well
    expect(codesOf(levels[0])).toEqual(['error proved-impossible', 'error run-does-not-complete']);
    expect(levels[0].problems[0]).toMatchObject({ pointer: '/blackHole', line: 1 });
    expect(codesOf(levels[2])).toEqual(['error no-run']);
  });

  it('warns of a mineral that nobody can collect, and of no others', async () => {
    const { code, levels } = await check('mineral.level.json');
    expect(code).toBe(0);
    expect(levels[0].problems.filter((p) => p.code === 'mineral-never-collectable')).toMatchObject([
      { severity: 'warning', pointer: '/minerals/1' },
    ]);
    expect(codesOf(levels[0])).not.toContain('warning mineral-out-of-reach');
  });

  it('refuses the limits of a search', async () => {
    for (const option of ['--budget', '--effort']) {
      const ended = await gq(['check', 'a', option, '5'], { cwd });
      expect(ended).toMatchObject({ code: 2, stdout: '' });
      expect(ended.stderr).toContain(`${option} limits the search of --solve`);
    }
  });
});

describe('--solve', () => {
  it('gives every level the right verdict, the same for any number of threads', async () => {
    const args = 'a --solve --effort 100000 --jobs';
    const [one, two] = await Promise.all([check(`${args} 1`), check(`${args} 2`, gqProcess)]);
    expect(withoutTimes(two.stdout)).toBe(withoutTimes(one.stdout));
    const { code, levels } = one;
    expect(code).toBe(1);
    expect(verdicts(levels)).toEqual([
      'Straight through: impossible',
      'Straight through: completable',
      'First Swing: completable',
      'Straight through: completable',
      'Needle: unproven',
    ]);
    const [, broken, found, good, needle] = levels;
    // a run that was found proves the level, and a problem says that none of its own runs does
    expect(codesOf(broken)).toEqual(expect.arrayContaining(['warning found-run', 'warning run-does-not-complete']));
    expect(codesOf(found)).toContain('warning found-run');
    expect(found.run).toMatchObject({ outcome: 'completed' });
    expect(found.problems[0].message).toContain(found.run?.holds.map((hold) => hold.join('-')).join(','));
    expect(codesOf(good)).toEqual([]);
    expect(codesOf(needle).filter((code) => code.startsWith('error'))).toEqual(['error no-run-found']);
    expect(needle.problems[0].message).toMatch(
      /it simulated \d+ runs, \d+ ticks; closest approach [\d.]+ px from the black hole/,
    );
    expect(needle.run).toBeNull();
  });

  it('passes a level that a found run completes; once the run is written, it passes without a search, too', async () => {
    const args = ['--objective', 'first', '--effort', '4000000', '--jobs', '1', '--write'];
    expect((await check('own.level.json --solve --effort 100000 --jobs 1')).code).toBe(0);
    expect((await gq(['solve', 'own.level.json', ...args], { cwd })).code).toBe(0);
    const { code, levels } = await check('own.level.json');
    expect(code).toBe(0);
    expect(levels[0].verdict).toBe('completable');
  });
});

describe('--require-slack', () => {
  const solution = shipped('04-slingshot');

  it('passes up to the certified ticks, and beyond is an error with a failing example; the verdict stays', async () => {
    const met = await check(`${solution} --require-slack 2`);
    expect([met.code, met.levels[0].problems]).toEqual([0, []]);
    const { code, levels } = await check(`${solution} --require-slack 4`);
    expect([code, levels[0].verdict]).toEqual([1, 'completable']);
    const [problem] = levels[0].problems.filter((p) => p.code === 'slack-below-required');
    expect(problem).toMatchObject({ severity: 'error', pointer: '/runs/0' });
    const [, fails] = /: (\S+) instead of \S+ fails; required: 4$/.exec(problem.message) ?? [];
    const { stdout } = await gq(['simulate', solution, '--holds', fails, '--format', 'json']);
    expect(JSON.parse(stdout).outcome).not.toBe('completed');
  });

  it('is not needed for a warning about little slack: --solve suffices', async () => {
    // found by hand: the last tick of a release that still leads into the black hole
    const text = withoutRuns('02-first-swing');
    const last = lastRelease(text, 150, 435);
    writeFileSync(
      join(cwd, 'edge.level.json'),
      JSON.stringify({ ...JSON.parse(text), runs: [{ name: 'edge', holds: [[150, last]] }] }),
    );
    const plain = await check('edge.level.json');
    expect(codesOf(plain.levels[0])).not.toContain('warning low-slack');
    const searched = await check('edge.level.json --solve --jobs 1');
    expect(searched.code).toBe(0);
    expect(codesOf(searched.levels[0])).toContain('warning low-slack');
  });

  function lastRelease(text: string, press: number, release: number): number {
    const read = readLevel(text);
    if (!read.ok) throw new Error('expected a valid level');
    const scene = compile(read.level);
    for (let at = release; ; at++) if (simulate(scene, [[press, at]]).outcome !== 'completed') return at - 1;
  }

  it.each(['-1', '61', 'two'])('refuses %s', async (value) => {
    const ended = await gq(['check', 'a', '--require-slack', value], { cwd });
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toContain('expected a number of ticks');
  });
});
