import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import * as z from 'zod';
import { accuracyPretty } from '../../cli/commands/accuracy/report.ts';
import { PLAIN } from '../../cli/terminal/terminal.ts';
import { cheapestGoodEnough, METHODS, measureWorkPrecision } from '../../engine/work-precision/index.ts';
import { gq, makeFiles } from '../cli/gq.ts';
import { SPECK, SWING, SWING_FILE } from './scenes.ts';

const files = makeFiles({
  'swing.level.json': JSON.stringify(SWING_FILE),
  'speck.level.json': JSON.stringify(SPECK),
  'broken.level.json': '{',
});
afterAll(() => files.remove());
const cwd = files.directory;

const outcome = z.enum(['completed', 'collided', 'lost', 'timeout']);
const method = z.object({
  name: z.string(),
  integrator: z.enum(['arcade', 'euler', 'verlet', 'rk4', 'taylor']),
  rate: z.number().positive().optional(),
  tolerance: z.number().positive().optional(),
  contact: z.enum(['frame', 'swept']),
  error: z.number().min(0),
  cost: z.number().positive(),
  costSpread: z.tuple([z.number(), z.number()]),
  outcome,
  sameVerdict: z.boolean(),
});
const reportShape = z.object({
  level: z.string(),
  holds: z.array(z.tuple([z.int(), z.int()])),
  reference: z.object({
    method: z.string(),
    tolerance: z.number().positive(),
    outcome,
    time: z.number().min(0),
    knownTo: z.number().positive().max(1e-15),
    doubt: z.null(),
  }),
  cheapest: z.object({ name: z.string(), error: z.number().max(0.01), cost: z.number().positive() }),
  methods: z.array(method.refine((m) => (m.rate === undefined) !== (m.tolerance === undefined))),
});

describe('gq accuracy', () => {
  it('reports in JSON in the published shape, and draws', async () => {
    const args = 'accuracy swing.level.json --format json --svg out.svg --max-time 2 --integrator verlet --rate 90'.split(' ');
    const { code, stdout, stderr } = await gq(args, { cwd });
    expect({ code, stderr }).toEqual({ code: 0, stderr: 'wrote out.svg\n' });
    const report = reportShape.parse(JSON.parse(stdout));
    expect(report).toMatchObject({ level: 'Swing', holds: [[0, 600]], reference: { outcome: 'timeout', time: 2 } });
    const names = report.methods.map(({ name }) => name);
    expect(names).toEqual(expect.arrayContaining(['arcade', 'fast', 'standard', 'precise', 'verlet 90 Hz', 'rk4 960 Hz, frame']));
    for (const m of report.methods) {
      expect(m.sameVerdict).toBe(m.outcome === report.reference.outcome);
      expect(m.costSpread[0]).toBe(m.cost);
      expect(m.costSpread[1]).toBeGreaterThanOrEqual(m.cost);
    }
    const error = (name: string) => report.methods.find((m) => m.name === name)?.error ?? Number.NaN;
    expect(error('precise')).toBeLessThan(error('standard'));
    expect(error('standard')).toBeLessThan(error('fast'));
    expect(error('fast')).toBeLessThan(error('arcade'));
    expect(readFileSync(join(cwd, 'out.svg'), 'utf8')).toMatch(/^<svg [\s\S]*<\/svg>\n$/);
  });

  // The same report as above, for people: here without the seconds that a command spends on exact costs.
  it('tells a designer which setting is the cheapest that will do', () => {
    const { holds } = SWING.runs[0];
    let readings = 0;
    const measured = measureWorkPrecision(SWING, holds, {
      maxTime: 1,
      maxWork: 400_000,
      now: () => readings++,
      budget: { comparing: 1e6, timing: 1e6, most: 1e6 },
      methods: METHODS,
    });
    const cheapest = cheapestGoodEnough(measured.methods);
    const terms = { accuracy: 'precise', maxTime: 1, maxWork: 400_000, rules: {} };
    const report = {
      file: 'swing.level.json',
      terms,
      level: SWING.name,
      run: 'run "swing"',
      holds,
      measured,
      cheapest,
      asked: null,
    };
    const text = accuracyPretty(report, PLAIN);
    expect(text).toContain('Swing, run "swing": timeout at 1.000000 s');
    expect(text).toMatch(/known to \d\.\de-\d\d px: so far is a second reference/);
    expect(text).toContain('taylor 1e-9 px = precise');
    expect(text).toMatch(/Cheapest with the same outcome and an error below 0\.01 px: /);
  });

  it.each([
    ['--cheapest --svg out.svg', /--svg is for the report of one level/],
    ['--cheapest --accuracy fast', /--cheapest tries every accuracy itself/],
    ['speck.level.json', /expected one level, found 2: give one, or --cheapest for many/],
    ['--svg out.png', /--svg out\.png: expected a name that ends in \.svg/],
    ['--run nothing', /no run is named "nothing"/],
    ['--rate 120', /--rate .*expected --integrator/],
    ['--contact frame', /--contact .*expected --integrator/],
    ['--integrator rk4', /expected --rate/],
    ['--integrator rk4 --tolerance 1e-3', /rk4 has fixed steps: expected --rate/],
    ['--integrator taylor', /expected --tolerance/],
    ['--integrator taylor --rate 60', /taylor chooses its own steps: expected --tolerance/],
    ['--integrator taylor --tolerance 1e-30', /expected an error of at least/],
    ['--integrator taylor --tolerance -1', /expected an error in px: more than 0/],
    ['--integrator verlet --rate 0', /expected steps a second: more than 0/],
    ['--integrator leapfrog --rate 60', /Allowed choices are euler, verlet, rk4, taylor/],
    ['--accuracy fast --integrator rk4 --rate 60', /cannot be combined/],
  ])('%s ends with 2 and what was expected', async (options, message) => {
    const { code, stdout, stderr } = await gq(['accuracy', 'swing.level.json', ...options.split(' ')], { cwd });
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toMatch(message);
  });

  it('ends with 1 for an invalid level', async () => {
    expect(await gq(['accuracy', 'broken.level.json'], { cwd })).toMatchObject({ code: 1, stdout: '' });
  });
});

describe('a setting of their own', () => {
  const run = async (...options: string[]) =>
    JSON.parse((await gq(['simulate', 'swing.level.json', '--max-time', '3', '--format', 'json', ...options], { cwd })).stdout);

  it('is what simulate plays, and its name is in the report', async () => {
    const [own, standard] = await Promise.all([run('--integrator', 'rk4', '--rate', '240'), run('--accuracy', 'standard')]);
    expect(own.accuracy).toBe('rk4 240 Hz');
    expect(own.hash).not.toBe(standard.hash);
  });

  it('with the parts of a named accuracy is that accuracy', async () => {
    const [own, standard] = await Promise.all([run('--integrator', 'rk4', '--rate', '60'), run('--accuracy', 'standard')]);
    expect(own).toEqual(standard);
  });
});

describe('gq check', () => {
  it('warns when a verdict hangs on the accuracy, and names what each gives', async () => {
    const { stdout } = await gq('check speck.level.json --format json'.split(' '), { cwd });
    const [{ problems }] = JSON.parse(stdout).levels;
    const warning = problems.find((p: { code: string }) => p.code === 'verdict-hangs-on-accuracy');
    expect(warning).toMatchObject({ severity: 'warning', pointer: '/runs/0' });
    expect(warning.message).toMatch(
      /completes the level under arcade, but not under precise \(collided with nova 1 .*fast .*standard/,
    );
  });

  it('does not where all agree', async () => {
    const { stdout } = await gq('check swing.level.json --format json'.split(' '), { cwd });
    const [{ problems }] = JSON.parse(stdout).levels;
    expect(problems.map((p: { code: string }) => p.code)).not.toContain('verdict-hangs-on-accuracy');
  });

  it('has the warning explained', async () => {
    expect(await gq(['explain', 'verdict-hangs-on-accuracy'])).toMatchObject({ code: 0 });
  });
});
