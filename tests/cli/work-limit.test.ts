import { afterAll, describe, expect, it } from 'vitest';
import { checkReportSchema, type LevelReport } from '../../schema/index.ts';
import { HEAVY_LEVELS } from '../scenes/heavy-levels.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const heavy = (name: string, size: number): string => JSON.stringify(HEAVY_LEVELS[name](size));

const files = makeFiles({
  'good.level.json': fallThrough(),
  'second.level.json': fallThrough({
    runs: [
      { name: 'through', holds: [[0, 3600]] },
      ...Array.from({ length: 40 }, (_, i) => ({
        name: `taps ${i}`,
        holds: Array.from({ length: 500 }, (_, k) => [2 * k + 1, 2 * k + 2]),
      })),
    ],
  }),
  'orbit.level.json': heavy('tiny-orbit', 1),
  'holds.level.json': heavy('many-holds', 0.01),
  'awake.level.json': heavy('awake-aliens', 0.05),
});
const cwd = files.directory;
afterAll(files.remove);

async function check(args: string): Promise<{ code: number | null; level: LevelReport }> {
  const { code, stdout, stderr } = await gq(['check', ...args.split(' '), '--format', 'json'], { cwd });
  expect(stderr).toBe('');
  return { code, level: checkReportSchema.parse(JSON.parse(stdout)).levels[0] };
}
const limitsOf = ({ problems }: LevelReport) => problems.filter(({ code }) => code === 'work-limit');

describe('--max-work', () => {
  it('makes a level unproven beyond the limit, with a problem that names the run and the work', async () => {
    const { code, level } = await check('--max-work 3000 orbit.level.json');
    expect(code).toBe(1);
    expect(level.verdict).toBe('unproven');
    const [limit] = limitsOf(level);
    expect(limit).toMatchObject({ severity: 'error', pointer: '/runs/0' });
    expect(limit.message).toMatch(
      /^run "hold" was not played beyond tick \d+: that takes more than the 3000 pieces of motion allowed$/,
    );
  });

  it.each(['orbit', 'holds', 'awake'])('stops at the same point every time: %s', async (name) => {
    const [one, other] = await Promise.all([1, 2].map(() => check(`--max-work 2000 ${name}.level.json`)));
    expect({ ...one.level, ms: 0 }).toEqual({ ...other.level, ms: 0 });
  });

  it('leaves a level completable if a run has completed it, with a warning about what was left out', async () => {
    const { code, level } = await check('--max-work 400 second.level.json');
    expect(code).toBe(0);
    expect(level.verdict).toBe('completable');
    expect(limitsOf(level)[0]).toMatchObject({ severity: 'warning' });
    expect(limitsOf(level)[0].message).toMatch(
      /^run "taps \d+" was not played beyond tick \d+, and the \d+ runs after it were not played at all: /,
    );
  });

  it('reports nothing if the work stays within the limit', async () => {
    const { code, level } = await check('good.level.json');
    expect(code).toBe(0);
    expect(limitsOf(level)).toEqual([]);
  });

  it('refuses a value that is not a number of pieces', async () => {
    const { code, stderr } = await gq(['check', '--max-work', '0', 'good.level.json'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toContain('expected pieces of motion: a whole number from 1');
  });

  it('is explained', async () => {
    const { code, stdout } = await gq(['explain', 'work-limit']);
    expect(code).toBe(0);
    expect(stdout).toContain('--max-work');
  });
});
