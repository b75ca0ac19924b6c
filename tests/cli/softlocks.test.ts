import { Ajv2020 } from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { softlocksOf } from '../../check/index.ts';
import { softlockLines } from '../../cli/reporters/pretty.ts';
import { compile, simulate, TICK } from '../../engine/index.ts';
import { type CheckReport, REPORT_SCHEMAS, reportJsonSchema, resolveLevel } from '../../schema/index.ts';
import { createSoftlockSurvey, LIVES_ON } from '../../solver/index.ts';
import { itDeep, itQuick } from '../depth.ts';
import { gq, makeFiles } from './gq.ts';

/** She drifts into the black hole unless the weak gun bends her way; past it she is too fast to come back. */
const past = (changes: Readonly<Record<string, unknown>> = {}) => ({
  version: 1,
  name: 'Past it',
  astronaut: { x: 0, y: 0, vx: 60 },
  blackHole: { x: 150, y: 30 },
  range: 450,
  rules: { pull: 10 },
  asteroids: [{ x: 60, y: -100, radius: 16 }],
  runs: [{ name: 'drift', holds: [] }],
  ...changes,
});

const files = makeFiles({
  'past.level.json': JSON.stringify(past()),
  'allowed.level.json': JSON.stringify(past({ allow: { softlock: 'the way out is the lesson' } })),
  'unproven.level.json': JSON.stringify(past({ runs: undefined })),
  'needless.level.json': JSON.stringify(past({ allow: { softlock: 'none of these' }, blackHole: { x: 60, y: 0 } })),
});
const cwd = files.directory;
afterAll(files.remove);
const run = (args: string) => gq(args.split(' '), { cwd });

/** Enough for the states of this level to be proved, ticks. */
const EFFORT = 5_000_000;

async function report(args: string): Promise<CheckReport> {
  const { stdout, stderr } = await run(`check ${args} --format json --no-cache`);
  expect(stderr).toBe('');
  return JSON.parse(stdout) as CheckReport;
}

let whole: Promise<CheckReport> | null = null;

/** The report with the whole effort; made once, as that takes seconds. */
async function wholeReport(): Promise<CheckReport> {
  whole ??= report(`past.level.json --softlocks ${EFFORT}`);
  return await whole;
}

describe('gq check --softlocks', () => {
  it('counts every examined state once, in words', () => {
    const base = { places: [], effort: { runs: 1, ticks: 1 }, isFinished: true };
    const counts = fc.tuple(...Array.from({ length: 6 }, () => fc.oneof(fc.nat(2), fc.nat(200))));
    fc.assert(
      fc.property(counts, ([open, proved, notFound, soonProved, soonNotFound, unknown]) => {
        const [line] = softlockLines({
          ...base,
          states: {
            examined: open + proved + notFound + soonProved + soonNotFound + unknown,
            open,
            proved: proved + soonProved,
            notFound: notFound + soonNotFound,
            unknown,
          },
          lasting: { proved, notFound },
        });
        const told = [...line.matchAll(/(\d+) \(\d+ %\)/g)].map(([, count]) => Number(count));
        const parts = [open, proved, notFound, soonProved + soonNotFound, unknown];
        expect(told).toEqual(parts.filter((count, i) => i < 3 || count > 0));
      }),
    );
  });

  itQuick('says in text what is proved and what was not found, apart, and warns only of what is proved', async () => {
    const { code, stdout } = await run(`check past.level.json --softlocks ${EFFORT} --max-warnings 0`);
    expect(code).toBe(1);
    expect(stdout).toMatch(/^1 level: 1 completable$/m);
    expect(stdout).toMatch(/warning softlock: she can live on for [\d.]+ s and more although the black hole is out of her reach/);
    expect(stdout).toMatch(
      /of \d+ states \d+ \(\d+ %\) open; lost although she lives on: \d+ \(\d+ %\) proved, \d+ \(\d+ %\) from which no run was found/,
    );
    expect(stdout).toMatch(/\(\d+, -?\d+\) from [\d.]+ s on, alive for [\d.]+ s after it: proved \(\w+\)/);
    for (const line of stdout.split('\n').filter((one) => one.includes('no run found in')))
      expect(line).toContain('which proves nothing');
    expect((await run('check past.level.json')).stdout).not.toContain('softlock');
  });

  itDeep('has in JSON the shape of its schema and the counts of a survey, and its places lie on runs that fail', async () => {
    const whole = await wholeReport();
    expect(new Ajv2020({ strict: false }).compile(reportJsonSchema('check'))(whole)).toBe(true);
    expect(REPORT_SCHEMAS.check.safeParse(whole)).toMatchObject({ success: true });
    const found = whole.levels[0].softlocks;
    const scene = compile(resolveLevel(past() as never));
    const survey = createSoftlockSurvey(scene);
    survey.advance(EFFORT);
    const { states, lasting, effort } = softlocksOf(survey);
    expect(found).toMatchObject({ states, lasting, effort });
    expect(found?.states.proved).toBeGreaterThan(20);
    for (const { holds, tick, alive, known, proof, searched, open } of found?.places ?? []) {
      expect(alive).toBeGreaterThanOrEqual(LIVES_ON);
      expect(open === null || open < tick).toBe(true);
      expect(known === 'proved' ? proof !== null && searched === null : proof === null && (searched ?? 0) > 0).toBe(true);
      // she is alive there, and does not complete the level by doing nothing more
      const way = simulate(scene, holds, { record: false });
      expect(way.time).toBeGreaterThan(tick * TICK);
      expect(way.outcome).not.toBe('completed');
    }
  });

  itDeep('gives the same for the same effort, and more effort leaves fewer states unproved', async () => {
    const brief = await report('past.level.json --softlocks 600000');
    expect((await report('past.level.json --softlocks 600000')).levels[0].softlocks).toEqual(brief.levels[0].softlocks);
    expect(brief.levels[0].softlocks?.isFinished).toBe(false);
    const longer = await wholeReport();
    expect(longer.levels[0].softlocks?.states.proved).toBeGreaterThan(brief.levels[0].softlocks?.states.proved ?? 0);
  });

  it('examines only levels that a run completes', async () => {
    const whole = await report('unproven.level.json --softlocks 100000');
    expect(whole.levels[0]).toMatchObject({ verdict: 'unproven' });
    expect(whole.levels[0].softlocks).toBeNull();
    expect(REPORT_SCHEMAS.check.safeParse(whole)).toMatchObject({ success: true });
    const { stdout } = await run('check unproven.level.json --softlocks 100000');
    expect(stdout).toContain('was not examined: no run completes the level');
  });

  itDeep('a level may allow it; an allowance that nothing needs is named where it was looked for', async () => {
    const allowed = await run(`check allowed.level.json --softlocks ${EFFORT} --max-warnings 0`);
    expect(allowed.code).toBe(0);
    expect(allowed.stdout).not.toContain('warning softlock');
    const needless = await run('check needless.level.json --softlocks 3000000');
    expect(needless.stdout).toContain('unused-allow');
    expect((await run('check needless.level.json')).stdout).not.toContain('unused-allow');
  });

  it.each(['0', '-1', '1.5', 'many', '1e400'])('refuses %s ticks with exit code 2', async (ticks) => {
    const { code, stdout, stderr } = await run(`check past.level.json --softlocks=${ticks}`);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(`argument '${ticks}' is invalid. expected a number of ticks: a whole number from 1`);
  });
});

describe('gq render --softlocks', () => {
  const render = (args: string) => run(`render past.level.json --softlocks -o - ${args}`);
  const count = (svg: string, text: string): number => svg.split(text).length - 1;

  itDeep('marks lost states and where they begin, in both themes, with a legend, the same every time', async () => {
    for (const [theme, effort] of [
      ['dark', EFFORT],
      ['light', 600_000],
    ] as const) {
      const { code, stdout, stderr } = await render(`--effort ${effort} --theme ${theme}`);
      expect({ code, stderr, drawn: count(stdout, 'data-kind="lost"') }).toEqual({ code: 0, stderr: '', drawn: 1 });
      expect(stdout).not.toMatch(/NaN|undefined|Infinity/);
      expect(stdout).toMatch(/<desc>Of \d+ states, \d+ can still reach the black hole\./);
      // a disc for what is proved, a dashed ring for what is not: colour alone tells nothing
      if (effort === EFFORT) expect(count(stdout, 'fill-opacity=".85"')).toBeGreaterThan(20);
    }
    expect((await render('--effort 600000')).stdout).toBe((await render('--effort 600000')).stdout);
  });

  it.each([
    ['--explored', '--explored and --softlocks cannot be combined'],
    ['--run drift', '--run and --softlocks cannot be combined'],
    ['--proof', '--proof and --softlocks cannot be combined'],
    ['--effort 0', "argument '0' is invalid"],
  ])('refuses %s beside it', async (more, message) => {
    const { code, stdout, stderr } = await render(more);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });
});
