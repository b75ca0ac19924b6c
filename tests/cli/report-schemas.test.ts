import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { afterAll, describe, expect } from 'vitest';
import { formatReportJsonSchema, REPORT_SCHEMAS, type ReportName, reportJsonSchema } from '../../schema/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';
import { shipped } from './levels.ts';
import { playOfRun } from './plays.ts';

const files = makeFiles({
  'good.level.json': fallThrough(),
  'other.level.json': fallThrough({ runs: [{ name: 'hold', holds: [[1, 600]] }] }),
  'invalid.level.json': '{',
  'broken.level.json': fallThrough({ blackHole: { x: 170, y: 60 } }),
  'away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 } }),
  'good.gqr': playOfRun('first-pull'),
  'cut.gqr': playOfRun('first-pull').subarray(0, 60),
  'originals.json': JSON.stringify([{ player: { x: 0, y: 0 }, target: { x: 170, y: 0, radius: 18 }, key: 1 }]),
});
afterAll(() => files.remove());
const cwd = files.directory;
const swing = shipped('02-first-swing');

/** Commands whose output must have the published shape; each name at least once. */
const COMMANDS: readonly [name: ReportName, args: string][] = [
  ['check', `check ${shipped('01-first-pull')} ${swing} good.level.json invalid.level.json`],
  ['simulate', `simulate ${swing} --sample 1`],
  ['simulate', `simulate ${swing} --holds none`],
  ['solve', 'solve good.level.json --effort 20000'],
  ['solve', 'solve good.level.json --effort 20000 --count 2'],
  ['fix', 'fix good.level.json'],
  ['fix', 'fix broken.level.json --effort 200000'],
  ['fix', 'fix away.level.json --effort 200000'],
  ['difficulty', 'difficulty good.level.json invalid.level.json --effort 20000'],
  ['tune', 'tune good.level.json --set pull=1.1x'],
  ['generate', 'generate --out made --seed 2 --difficulty easy --size medium --ingredients none'],
  ['accuracy', 'accuracy good.level.json --max-time 0.1'],
  ['accuracy', 'accuracy good.level.json --cheapest'],
  ['inspect', `inspect ${swing}`],
  ['inspect', `inspect ${swing} --time`],
  ['explain', 'explain'],
  ['explain', 'explain unknown-key'],
  ['explain', 'explain out-of-range'],
  ['fmt', 'fmt --check .'],
  ['import', 'import originals.json --out imported'],
  ['export', 'export good.level.json --to gravityquest --drop --output exported.json'],
  ['init', 'init new'],
  ['build', 'build good.level.json --out site'],
  ['build', 'build good.level.json invalid.level.json --out refused'],
  ['diff', 'diff good.level.json other.level.json'],
  ['verify', `verify good.gqr --levels ${shipped('01-first-pull')}`],
  ['verify', `verify good.gqr --levels ${swing}`],
  ['verify', `verify cut.gqr --levels ${swing}`],
];

describe('the JSON of every command', () => {
  const ajv = new Ajv2020({ strict: false });
  const validators = new Map(COMMANDS.map(([name]) => [name, ajv.compile(reportJsonSchema(name))]));

  it('is tried for each', () => {
    expect([...validators.keys()].sort()).toEqual(Object.keys(REPORT_SCHEMAS).sort());
  });

  const hasItsShape = async (name: (typeof COMMANDS)[number][0], args: string) => {
    const { stdout, stderr } = await gq([...args.split(' '), '--format', 'json'], { cwd });
    expect(stdout, stderr).toMatch(/^\{\s*"version":\s*1,/);
    const report = JSON.parse(stdout);
    const validate = validators.get(name)!;
    expect(validate(report) ? [] : validate.errors).toEqual([]);
    // no key is missing from the schema, which itself allows others
    expect(REPORT_SCHEMAS[name].safeParse(report)).toMatchObject({ success: true });
    expect(validate({ ...report, version: 2 })).toBe(false);
  };
  const HAS_ITS_SHAPE = '%s begins with its version and has the published shape: gq %s';
  // gq accuracy measures every accuracy, for seconds; tests/accuracy looks at the shape of one report
  const isDear = ([name]: (typeof COMMANDS)[number]) => name === 'accuracy';
  it.each(COMMANDS.filter((command) => !isDear(command)))(HAS_ITS_SHAPE, hasItsShape);
  itDeep.each(COMMANDS.filter(isDear))(HAS_ITS_SHAPE, hasItsShape);
});

describeQuick('gq schema', () => {
  it.each(Object.keys(REPORT_SCHEMAS) as ReportName[])('%s prints the committed file (updated by vitest -u)', async (name) => {
    const { code, stdout } = await gq(['schema', name]);
    expect({ code, stdout }).toEqual({ code: 0, stdout: formatReportJsonSchema(name) });
    await expect(stdout).toMatchFileSnapshot(`../../schema/reports/${name}.schema.json`);
  });

  it('prints that of a level without a name, and refuses an unknown name', async () => {
    const level = readFileSync(join(import.meta.dirname, '../../schema/level.schema.json'), 'utf8');
    expect((await gq(['schema'])).stdout).toBe(level);
    expect(await gq(['schema', 'chekc'])).toMatchObject({
      code: 2,
      stderr: expect.stringContaining(
        'there is no schema "chekc" (did you mean check?): expected level, config, pack, lock, check',
      ),
    });
  });
});
