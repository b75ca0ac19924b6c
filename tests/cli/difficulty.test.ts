import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect } from 'vitest';
import { difficultyReportSchema } from '../../schema/index.ts';
import { itQuick as it, itDeep } from '../depth.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';
import { shipped, withoutRuns } from './levels.ts';

const files = makeFiles({
  'alone.level.json': withoutRuns('12-detour'),
  'd/away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 } }),
  'd/invalid.level.json': '{ "version": 1 }',
  'd/through.level.json': fallThrough(),
  'd/unsolved.level.json': withoutRuns('01-first-pull'),
  'named.level.json': fallThrough({
    runs: [
      { name: 'never', holds: [] },
      { name: 'all', holds: [[0, 600]] },
    ],
  }),
});
const cwd = files.directory;
afterAll(files.remove);

const difficulty = async (args: string, run = gq) => {
  const { code, stdout, stderr } = await run(['difficulty', ...args.split(' '), '--format', 'json'], { cwd });
  return { code, stderr, stdout, levels: difficultyReportSchema.parse(JSON.parse(stdout)).levels };
};

describe('gq difficulty', () => {
  itDeep('has the same result for any number of threads', async () => {
    const args = 'd --effort 40000 --jobs';
    const ended = await Promise.all([difficulty(`${args} 1`), difficulty(`${args} 2`, gqProcess)]);
    expect(ended[1].stdout).toBe(ended[0].stdout);
  });

  it('measures each level it can, and gives the reason for the others', async () => {
    const { code, levels } = await difficulty('d --effort 40000 --jobs 1');
    expect(code).toBe(1);
    const [away, invalid, through, unsolved] = levels;
    expect(away).toMatchObject({ measured: null, why: expect.stringMatching(/^proved impossible: /) });
    expect(invalid).toMatchObject({ measured: null, why: 'not a valid level' });
    expect(invalid.problems.map((problem) => problem.code)).toContain('missing-key');
    expect(through.measured).toMatchObject({ run: { name: 'hold' }, presses: 1, robustness: { p30: 1 } });
    expect(unsolved.measured?.run.name).toBeNull();
  });

  it('prints a table of several levels, the easiest first', async () => {
    const { code, stdout } = await gq(['difficulty', 'd', '--effort', '40000', '--jobs', '1'], { cwd });
    expect(code).toBe(1);
    const grades = [...stdout.matchAll(/^ +(\d+\.\d) {2}\w+ /gm)].map(([, grade]) => Number(grade));
    expect(grades).toEqual(grades.toSorted((a, b) => a - b));
    expect(grades).toHaveLength(2);
    expect(stdout).toContain('d/away.level.json: not measured: proved impossible');
  });

  it('prints the details of a single level, and draws it', async () => {
    const ended = await gq(['difficulty', shipped('02-first-swing'), '--svg', 'one.svg', '--jobs', '1'], { cwd });
    expect(ended).toMatchObject({ code: 0, stderr: 'wrote one.svg\n' });
    for (const line of [
      /^First Swing: \w+, \d\.\d of 10\n/,
      /\nwindow {6}/,
      /\ncompared {4}\d runs, of which this one forgives most; the mean of all: grade \d\.\d, /,
      /\nmodel {7}of \d+ synthetic players: \d.* % pass at the first attempt/,
      /\n {12}not calibrated: /,
      /\nno press {4}does not complete it\n/,
      /\none press {3}/,
      /\nasteroid 1 {2}/,
    ])
      expect(ended.stdout).toMatch(line);
    const svg = readFileSync(join(cwd, 'one.svg'), 'utf8');
    expect(svg).toMatch(/^<svg [^>]*><title>How hard First Swing is: /);
  });

  it('measures the selected run, which must complete the level', async () => {
    const named = await difficulty('named.level.json --run all --jobs 1');
    expect([named.code, named.levels[0].measured?.run.name]).toEqual([0, 'all']);
    const never = await difficulty('named.level.json --run never --jobs 1');
    expect([never.code, never.levels[0].why]).toEqual([1, 'run "never" does not complete it']);
    const missing = await difficulty('named.level.json --run nobody --jobs 1');
    expect([missing.code, missing.levels[0].why]).toEqual([1, 'it has no run named "nobody"']);
    // by default: the first run that completes it
    expect((await difficulty('named.level.json --jobs 1')).levels[0].measured?.run.name).toBe('all');
  });

  itDeep(
    "compares the level's own runs with those of a search, measures the one that forgives most, and names runs of the level",
    async () => {
      // too little effort for a search without known runs
      const alone = await difficulty('alone.level.json --effort 100 --jobs 1');
      expect([alone.code, alone.levels[0].why]).toEqual([
        1,
        expect.stringMatching(/^no run was found after simulating \d+ runs?, \d+ ticks/),
      ]);
      const { code, levels } = await difficulty(`${shipped('22-vault')} --effort 100 --jobs 1`);
      const { run, comparison, grade, robustness, forecast } = levels[0].measured!;
      expect(code).toBe(0);
      const [first, ...others] = comparison.runs;
      expect(others.length).toBeGreaterThan(0);
      expect([run.name, run.holds]).toEqual([first.name, first.holds]);
      expect(comparison.runs.map(({ name }) => name)).toContain('solution');
      expect(comparison.meanP40).toBeLessThanOrEqual(first.p40 + 0.02);
      expect(grade.value).toBeLessThanOrEqual(Math.min(...comparison.runs.map((own) => own.grade)) + 0.1001);
      expect(Math.abs(robustness.p40 - first.p40)).toBeLessThan(0.05);
      expect(forecast!.attempts[0].pass.p).toBeLessThan(forecast!.attempts[9].pass.p);
    },
  );

  it.each([
    ['named.level.json --svg picture.png', 'expected a name that ends in .svg'],
    ['nowhere', 'matches no level file'],
    ['named.level.json --effort 1.5', 'expected a number of ticks'],
  ])('gq difficulty %s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await gq(['difficulty', ...args.split(' ')], { cwd });
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });
});
