import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { intervalAround } from '../../cli/tune/tune-level.ts';
import { compile, simulate } from '../../engine/index.ts';
import { readLevel, tuneReportSchema } from '../../schema/index.ts';
import { itDeep } from '../depth.ts';
import { fallThrough, gq, gqProcess, makeFiles } from './gq.ts';

const cwd = fileURLToPath(new URL('./fixtures', import.meta.url));
const LEVELS = fileURLToPath(new URL('../../levels', import.meta.url));

// name of the folder under fixtures/ with the whole expected output (updated by vitest -u), arguments, exit code
const CASES: readonly [name: string, args: string, code: number][] = [
  ['tune-sweep', 'tune ../../../levels/0*.level.json --sweep pull=0.8x..1.2x:41', 0],
  ['tune-set', 'tune ../../../levels/1*.level.json --set pull=1.05x --set alienSight=160', 0],
  ['tune-json', 'tune levels/01-through.level.json levels/02-past-a-nova.level.json --sweep push=10..30:3 --format json', 0],
  ['tune-invalid', 'tune levels --set pull=40 --accuracy arcade', 1],
];

describe.each(CASES)('%s', (name, args, code) => {
  it(`gq ${args}`, async () => {
    const ended = await gq(args.split(' '), { cwd });
    expect(ended).toMatchObject({ code, signal: null });
    expect(ended.stdout.split('\n').every((line) => [...line].length <= 80 || line.startsWith('{'))).toBe(true);
    await expect(ended.stdout).toMatchFileSnapshot(`fixtures/${name}/stdout.txt`);
    await expect(ended.stderr).toMatchFileSnapshot(`fixtures/${name}/stderr.txt`);
  });
});

const json = async (args: readonly string[], folder = cwd, run = gq) => {
  const { stdout, code, stderr } = await run(['tune', ...args, '--format', 'json'], { cwd: folder });
  expect({ code, stderr }).toEqual({ code: 0, stderr: '' });
  return tuneReportSchema.parse(JSON.parse(stdout));
};

describe('gq tune', () => {
  itDeep('agrees with replays at each value and threshold, for any number of threads', async () => {
    const args = [join(LEVELS, '0*.level.json'), '--sweep', 'pull=0.9x..1.1x:3', '--accuracy', 'fast'];
    const report = await json([...args, '--jobs', '1']);
    expect(await json([...args, '--jobs', '2'], cwd, gqProcess)).toEqual(report);
    expect(report.levels.length).toBeGreaterThan(5);
    let bounds = 0;
    for (const { file, run, values, intervals } of report.levels) {
      const read = readLevel(readFileSync(file));
      if (!read.ok) throw new Error(`expected a valid level in ${file}`);
      const holds = read.level.runs.find(({ name }) => name === run)?.holds ?? [];
      const works = (pull: number) =>
        simulate(compile({ ...read.level, rules: { ...read.level.rules, pull } }, 'fast'), holds).outcome === 'completed';
      for (const { value, state } of values) expect(works(value ?? Number.NaN)).toBe(state === 'kept');
      for (const { low, high, own, isLowBound, isHighBound } of intervals) {
        if (low === null || high === null) continue;
        expect(works(low) && works(high)).toBe(true);
        // bisection has ended between here and a thousandth farther
        if (isLowBound) bounds++;
        if (isHighBound) bounds++;
        expect(low).toBeLessThanOrEqual(own);
        expect(high).toBeGreaterThanOrEqual(own);
      }
    }
    expect(bounds).toBeGreaterThan(5);
    const rooms = report.levels.map(({ room }) => room ?? Number.POSITIVE_INFINITY);
    expect(rooms).toEqual([...rooms].sort((a, b) => a - b));
  });

  it('finds another run if a search is requested', async () => {
    const file = join(LEVELS, '03-let-go.level.json');
    const args = [file, '--set', 'pull=0.9x', '--accuracy', 'fast'];
    const valueWith = async (...more: string[]) => (await json([...args, ...more])).levels[0].values[0];
    expect(await valueWith()).toEqual({ value: null, state: 'unproven', holds: null });
    expect(await valueWith('--solve', '--effort', '1', '--jobs', '1')).toMatchObject({ state: 'unproven' });
    const { state, holds } = await valueWith('--solve', '--effort', '150000', '--jobs', '1');
    expect(state).toBe('other');
    const read = readLevel(readFileSync(file), { rules: { pull: 0.9 * 39 } });
    if (!read.ok) throw new Error('expected a valid level');
    expect(simulate(compile(read.level, 'fast'), holds ?? []).outcome).toBe('completed');
  });

  it('names the rules that no level depends on', async () => {
    const report = await json([
      join(LEVELS, '01-first-pull.level.json'),
      '--set',
      'push=21',
      '--set',
      'pull=40',
      '--set',
      'alienPull=9',
    ]);
    expect(report.independent).toEqual(['push', 'alienPull']);
  });

  it('starts from the rules of the level, and of the folder where the level has none', async () => {
    const { directory, remove } = makeFiles({
      'gq.config.json': '{ "rules": { "pull": 50 } }',
      'a.level.json': fallThrough(),
      'b.level.json': fallThrough({ rules: { pull: 60 } }),
    });
    try {
      const { levels } = await json(['.', '--sweep', 'pull=0.9x..1.1x:3'], directory);
      const owns = levels.map(({ file, intervals, values }) => [file, intervals[0].own, values[2].value]);
      expect(owns.sort()).toEqual([
        ['a.level.json', 50, 55.00000000000001],
        ['b.level.json', 60, 66],
      ]);
    } finally {
      remove();
    }
  });

  it('draws the matrix, with a shape for each state', async () => {
    const { directory, remove } = makeFiles({});
    try {
      const file = join(directory, 'pull.svg');
      const levels = join(LEVELS, '0*.level.json');
      const { code, stderr } = await gq(['tune', levels, '--sweep', 'pull=0.8x..1.2x:9', '--accuracy', 'arcade', '--svg', file]);
      expect({ code, stderr }).toEqual({ code: 0, stderr: `wrote ${file}\n` });
      await expect(readFileSync(file, 'utf8')).toMatchFileSnapshot('fixtures/tune-sweep/pull.svg');
    } finally {
      remove();
    }
  });

  it.each([
    ['--set pul=1.1x', 'did you mean pull?'],
    ['--set pull', 'expected RULE=VALUE'],
    ['--set pull=', 'expected a number'],
    ['--set pull=-3', 'expected a number'],
    ['--set pull=1e3', 'expected a number'],
    ['--set pull=0.5', 'expected 1 to 1000'],
    ['--set pull=40 --set pull=41', 'set twice'],
    ['--set speedLimit=1.1x', 'speedLimit: 1.1x of 1000 is 1100'],
    ['--sweep pull=1x..2x', 'expected RULE=FROM..TO:COUNT'],
    ['--sweep pull=1x..50:3', 'expected both ends'],
    ['--sweep pull=2x..1x:3', 'expected FROM below TO'],
    ['--sweep pull=1x..2x:1', 'expected 2 to 1001 values'],
    ['--sweep pusch=1x..2x:3', 'did you mean push?'],
    ['--sweep pull=1x..2x:3 --set pull=2x', 'cannot be combined'],
    ['--set pull=40 --budget 3', 'give --solve as well'],
    ['--set pull=40 --svg picture.png', 'ends in .svg'],
    ['', 'no rule is changed'],
  ])('refuses %s', async (args, words) => {
    const { code, stderr } = await gq(['tune', 'levels/01-through.level.json', ...args.split(' ').filter((arg) => arg !== '')], {
      cwd,
    });
    expect(code).toBe(2);
    expect(stderr).toContain(words);
    expect(existsSync(join(cwd, 'picture.png'))).toBe(false);
  });
});

describe('the interval around a value', () => {
  it('ends at the threshold, to a thousandth of the value', () => {
    const value = fc.integer({ min: 1, max: 1000 }).map((k) => k / 7);
    fc.assert(
      fc.property(value, value, value, fc.integer({ min: 2, max: 60 }), (own, below, above, count) => {
        const [from, to] = [own - below, own + above];
        const works = (v: number) => v >= from && v <= to;
        const values = Array.from({ length: count }, (_, i) => own * (0.5 + (1.5 * i) / (count - 1)));
        const found = intervalAround(own, values, works);
        if (found === null) throw new Error('expected an interval: it works at the value itself');
        const [least, most] = [Math.min(own, ...values), Math.max(own, ...values)];
        expect([found.isLowBound, found.isHighBound]).toEqual([from > least, to < most]);
        expect(Math.abs(found.low - Math.max(from, least))).toBeLessThanOrEqual(1e-3 * own);
        expect(Math.abs(found.high - Math.min(to, most))).toBeLessThanOrEqual(1e-3 * own);
        expect(works(found.low) && works(found.high)).toBe(true);
      }),
    );
    expect(intervalAround(1, [0.5, 2], () => false)).toBeNull();
  });
});
