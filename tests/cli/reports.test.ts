import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { checkReportSchema, simulateReportSchema } from '../../schema/index.ts';
import { gq } from './gq.ts';
import { withoutTimes } from './levels.ts';

const cwd = fileURLToPath(new URL('./fixtures', import.meta.url));

// name of the folder under fixtures/ with the whole expected output (updated by vitest -u), arguments, exit code
const CASES: readonly [name: string, args: string, code: number][] = [
  ['check-pretty', 'check levels --accuracy arcade', 1],
  ['check-json', 'check levels --accuracy arcade --format json', 1],
  ['check-github', 'check levels --accuracy arcade --format github', 1],
  ['check-completable', 'check levels/01-through.level.json levels/02-past-a-nova.level.json --accuracy arcade', 0],
  ['check-unmatched', 'check levels/01-through.level.json levels/01-thruogh.level.json nowhere/*.json', 2],
  ['simulate-pretty', 'simulate levels/01-through.level.json --accuracy arcade --sample 2', 0],
  ['simulate-json', 'simulate levels/01-through.level.json --accuracy arcade --sample 2 --format json', 0],
  ['simulate-drift', 'simulate levels/04-no-run.level.json --accuracy arcade --holds none --max-time 1', 0],
  ['simulate-collided', 'simulate levels/03-into-a-nova.level.json --accuracy arcade --run short', 0],
  ['simulate-invalid', 'simulate levels/06-misspelt.level.json --format json', 1],
  ['inspect-pretty', 'inspect levels/05-out-of-reach.level.json --accuracy arcade', 0],
  ['inspect-json', 'inspect levels/02-past-a-nova.level.json --accuracy arcade --format json', 0],
  ['solve-impossible', 'solve levels/05-out-of-reach.level.json --accuracy arcade', 1],
  ['solve-impossible-json', 'solve levels/05-out-of-reach.level.json --accuracy arcade --format json', 1],
  ['check-require-slack', 'check levels/02-past-a-nova.level.json --accuracy arcade --require-slack 20', 1],
  ['difficulty-pretty', 'difficulty levels/02-past-a-nova.level.json --accuracy arcade', 0],
  ['difficulty-table', 'difficulty levels/01-through.level.json levels/03-into-a-nova.level.json --accuracy arcade', 1],
  ['explain-impossible', 'explain proved-impossible', 0],
  ['fmt-check', 'fmt --check levels', 1],
  ['explain', 'explain run-does-not-complete', 0],
];

describe.each(CASES)('%s', (name, args, code) => {
  it(`gq ${args}`, async () => {
    const ended = await gq(args.split(' '), { cwd });
    expect(ended).toMatchObject({ code, signal: null });
    await expect(withoutTimes(ended.stdout)).toMatchFileSnapshot(`fixtures/${name}/stdout.txt`);
    await expect(ended.stderr).toMatchFileSnapshot(`fixtures/${name}/stderr.txt`);
  });
});

it('reports in JSON have the published shapes, and a verdict contains the same run as simulate', async () => {
  const [check, simulate] = await Promise.all([
    gq('check levels --accuracy arcade --format json'.split(' '), { cwd }),
    gq('simulate levels/01-through.level.json --accuracy arcade --format json'.split(' '), { cwd }),
  ]);
  const report = checkReportSchema.parse(JSON.parse(check.stdout));
  const { version, ...run } = simulateReportSchema.parse(JSON.parse(simulate.stdout));
  expect(version).toBe(1);
  expect(report.levels[0].run).toEqual(run);
  expect(report.levels.reduce((sum, level) => sum + (level.verdict === 'invalid' ? 1 : 0), 0)).toBe(report.summary.invalid);
  expect(report.levels).toHaveLength(Object.values(report.summary).reduce((a, b) => a + b, 0));
});

it('recoil can be turned on and off from the command line', async () => {
  const hash = async (...args: string[]): Promise<string> => {
    const { stdout } = await gq(
      ['simulate', 'levels/01-through.level.json', '--accuracy', 'arcade', '--format', 'json', ...args],
      { cwd },
    );
    return JSON.parse(stdout).hash;
  };
  const [plain, off, on] = await Promise.all([hash(), hash('--recoil', 'off'), hash('--recoil', 'on')]);
  expect(off).toBe(plain);
  expect(on).not.toBe(plain);
});
