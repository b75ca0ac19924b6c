import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { Ajv } from 'ajv';
import formats from 'ajv-formats';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { checkSarif } from '../../../cli/reporters/sarif.ts';
import { itDeep } from '../../depth.ts';
import { fallThrough, gq, makeFiles } from '../gq.ts';
import { brokenLevel, CONTEXT, checkedLevel, resultsOf, shownProblem } from './context.ts';

// the schema is of draft 4, of which it uses nothing that has another meaning in draft 7, but for the name of its id
const {
  id: _,
  $schema,
  ...schema
} = JSON.parse(readFileSync(new URL('./fixtures/sarif-schema-2.1.0.json', import.meta.url), 'utf8'));
const ajv = new Ajv({ strict: false, allErrors: true });
(formats as unknown as (ajv: Ajv) => void)(ajv);
const isValid = ajv.compile(schema);
const problemsOf = (report: unknown): unknown => (isValid(report) ? [] : isValid.errors);

interface Result {
  readonly ruleId: string;
  readonly ruleIndex: number;
  readonly level: string;
  readonly message: { readonly text: string };
  readonly locations: readonly {
    readonly physicalLocation: { readonly artifactLocation: { uri: string }; readonly region?: object };
  }[];
  readonly partialFingerprints: Readonly<Record<string, string>>;
}

const runOf = (text: string) => {
  const report = JSON.parse(text);
  expect(problemsOf(report)).toEqual([]);
  const [run] = report.runs;
  return run as { readonly results: readonly Result[]; readonly tool: { driver: { rules: { id: string }[] } } } & Record<
    string,
    unknown
  >;
};

const files = makeFiles({ 'game/levels/ä b%.level.json': fallThrough({ runs: [], asteriods: [] }) });
afterAll(() => files.remove());

const hostile = fc.string({
  unit: fc.oneof(
    fc.constantFrom('%', '/', '?', '#', ':', '\\', '🚀', '\ud800', '\u0000', ' '),
    fc.string({ unit: 'binary', maxLength: 2 }),
  ),
});

describe('the sarif reporter', () => {
  it('is valid and percent-encodes paths, whatever is in them', () => {
    fc.assert(
      fc.property(fc.array(fc.tuple(hostile, hostile), { maxLength: 3 }), (texts) => {
        const levels = texts.map(([file, message]) =>
          brokenLevel({ file: `levels/x${file}`, problems: [shownProblem({ message: `m${message}` })] }),
        );
        const run = runOf(checkSarif(resultsOf(levels, { unchecked: texts.map(([file]) => file), interrupted: true }), CONTEXT));
        expect(run.results).toHaveLength(texts.length);
        for (const { locations } of run.results)
          expect(locations[0].physicalLocation.artifactLocation.uri).toMatch(/^[\w%.!~*'()/-]+$|^file:/);
      }),
      { numRuns: 50 },
    );
  });

  it('would be refused without its results', () => {
    const report = JSON.parse(checkSarif(resultsOf([brokenLevel()]), CONTEXT));
    const [run] = report.runs;
    expect(problemsOf({ ...report, runs: [{ ...run, tool: undefined }] })).not.toEqual([]);
    expect(problemsOf({ ...report, runs: [{ ...run, results: [{}] }] })).not.toEqual([]);
  });

  it('has the places, rules and levels of the problems', () => {
    const warning = shownProblem({
      code: 'low-slack',
      severity: 'warning',
      line: null,
      column: null,
      message: 'tight',
      hint: '',
    });
    const levels = [brokenLevel(), checkedLevel({ file: '/elsewhere/b.level.json', problems: [warning] })];
    const text = checkSarif(resultsOf(levels), CONTEXT);
    expect(checkSarif(resultsOf(levels), CONTEXT)).toBe(text);
    const run = runOf(text);
    expect(run).toMatchObject({
      columnKind: 'utf16CodeUnits',
      invocations: [{ exitCode: 1, executionSuccessful: true, toolExecutionNotifications: [] }],
      originalUriBaseIds: { '%SRCROOT%': { uri: 'file:///project/' } },
      tool: { driver: { name: 'gq', version: '1.2.3' } },
      results: [
        {
          level: 'error',
          locations: [
            {
              physicalLocation: {
                artifactLocation: { uri: 'levels/a.level.json', uriBaseId: '%SRCROOT%' },
                region: { startLine: 9, startColumn: 5 },
              },
            },
          ],
        },
        { level: 'warning', message: { text: 'tight' } },
      ],
    });
    expect(run.results[0].message.text).toBe(
      'unknown key "asteriods"\nWrite "asteroids".\nlook at it: gq edit --open levels/a.level.json:120',
    );
    expect(run.results[1].locations[0].physicalLocation.artifactLocation).toEqual({ uri: 'file:///elsewhere/b.level.json' });
    for (const { ruleId, ruleIndex } of run.results) expect(run.tool.driver.rules[ruleIndex].id).toBe(ruleId);
    expect(run.tool.driver.rules[1]).toMatchObject({
      id: 'run-does-not-complete',
      shortDescription: { text: expect.any(String) },
      help: { markdown: expect.stringContaining('**How to fix it:**') },
      defaultConfiguration: { level: 'error' },
    });
  });

  itDeep('has at most as many results as GitHub takes, errors first, and counts the others', () => {
    const MOST = 25_000;
    const levelsWith = (errors: number, warnings: number) => {
      const problems = [
        ...Array.from({ length: warnings }, (_, i) => shownProblem({ severity: 'warning', code: 'low-slack', line: i + 1 })),
        ...Array.from({ length: errors }, (_, i) => shownProblem({ line: i + 1 })),
      ];
      // warnings stand before errors, in one level and in several
      const third = Math.ceil(problems.length / 3);
      return [0, 1, 2].map((i) =>
        brokenLevel({ file: `levels/${i}.level.json`, problems: problems.slice(i * third, (i + 1) * third) }),
      );
    };
    const cases = [
      [0, MOST, 0, MOST, null],
      [10, MOST, 10, MOST - 10, '10 warnings'],
      [MOST, 1, MOST, 0, '1 warning'],
      [MOST + 7, 5000, MOST, 0, '7 errors and 5000 warnings'],
    ] as const;
    for (const [errors, warnings, keptErrors, keptWarnings, lost] of cases) {
      const results = resultsOf(levelsWith(errors, warnings));
      const text = checkSarif(results, CONTEXT);
      const [run] = JSON.parse(text).runs;
      const count = (level: string) => run.results.filter((result: Result) => result.level === level).length;
      expect([count('error'), count('warning')]).toEqual([keptErrors, keptWarnings]);
      const lines = (level: string) =>
        run.results.flatMap((result: Result) =>
          result.level === level ? [(result.locations[0].physicalLocation.region as { startLine: number }).startLine] : [],
        );
      expect(lines('error')).toEqual(Array.from({ length: keptErrors }, (_, i) => i + 1));
      expect(lines('warning')).toEqual(Array.from({ length: keptWarnings }, (_, i) => i + 1));
      const named = run.results.map(({ ruleIndex }: { ruleIndex: number }) => run.tool.driver.rules[ruleIndex].id);
      expect(named).toEqual(run.results.map(({ ruleId }: Result) => ruleId));
      const rules = run.tool.driver.rules.map(({ id }: { id: string }) => id);
      expect(rules).toEqual([...(keptWarnings > 0 ? ['low-slack'] : []), ...(keptErrors > 0 ? ['unknown-key'] : [])].sort());
      const said = run.invocations[0].toolExecutionNotifications;
      if (lost === null) expect(said).toEqual([]);
      else expect(said).toEqual([{ level: 'warning', message: { text: expect.stringMatching(`^${lost} left out: a run may`) } }]);
      // a problem has the same fingerprint whatever is left out
      const fingerprints = run.results.map((result: Result) => result.partialFingerprints['gqProblem/v1']);
      expect(new Set(fingerprints).size).toBe(fingerprints.length);
      // GitHub takes 10 MB, packed
      expect(gzipSync(text).length).toBeLessThan(10_000_000);
      if (lost !== null)
        expect(problemsOf({ ...JSON.parse(text), runs: [{ ...run, results: run.results.slice(0, 9) }] })).toEqual([]);
    }
  });

  it('says how many levels of a set are not listed, and names only some that were not checked', () => {
    const unchecked = Array.from({ length: 130 }, (_, i) => `levels/${i}.level.json`);
    const run = runOf(checkSarif(resultsOf([brokenLevel()], { unlisted: 3, unchecked }), CONTEXT));
    const [invocation] = run.invocations as { toolExecutionNotifications: { message: { text: string } }[] }[];
    const [first, second] = invocation.toolExecutionNotifications.map(({ message }) => message.text);
    expect(first).toBe('and 3 levels more that fail: --format json lists all levels');
    expect(second).toMatch(/^the check ended early: 130 levels not checked: levels\/0\..*levels\/99\.level\.json and 30 more$/);
  });

  it('names files relative to the root of the repository or the workspace', async () => {
    const cwd = join(files.directory, 'game');
    const uris = async (env: Record<string, string>) => {
      const { stdout } = await gq(['check', '--format', 'sarif'], { cwd, env });
      return runOf(stdout).results.map(({ locations }) => locations[0].physicalLocation.artifactLocation.uri);
    };
    expect(await uris({ GITHUB_WORKSPACE: files.directory })).toEqual(['game/levels/%C3%A4%20b%25.level.json']);
    mkdirSync(join(files.directory, '.git'));
    expect(await uris({})).toEqual(['game/levels/%C3%A4%20b%25.level.json']);
    renameSync(join(files.directory, '.git'), join(cwd, '.git'));
    expect(await uris({})).toEqual(['levels/%C3%A4%20b%25.level.json']);
  });

  it('keeps fingerprints when lines, objects, runs and other problems come before', async () => {
    const { directory, remove } = makeFiles({});
    const asteroid = (id: string, more = {}) => ({ id, x: 100, y: 0, radius: 16, ...more });
    const fingerprints = async (level: Record<string, unknown>, layout: number) => {
      writeFileSync(join(directory, 'a.level.json'), JSON.stringify(JSON.parse(fallThrough(level)), null, layout));
      const { stdout } = await gq(['check', 'a.level.json', '--format', 'sarif'], { cwd: directory });
      return runOf(stdout).results.map(({ ruleId, partialFingerprints }) => `${ruleId} ${partialFingerprints['gqProblem/v1']}`);
    };
    const wrong = asteroid('bbbbbb', { raduis: 1 });
    const before = await fingerprints({ asteroids: [asteroid('aaaaaa'), wrong] }, 0);
    expect(before).toHaveLength(1);
    const after = await fingerprints(
      { description: 'x', asteroids: [asteroid('cccccc', { hots: true }), asteroid('aaaaaa'), wrong] },
      2,
    );
    expect(after).toHaveLength(2);
    expect(after).toContain(before[0]);
    const run = (name: string) => ({ name, holds: [[5, 6]] });
    const runs = await fingerprints({ runs: [run('b'), run('c')] }, 0);
    expect(new Set(runs).size).toBe(runs.length);
    const more = await fingerprints({ runs: [run('a'), run('c'), run('b')] }, 1);
    for (const one of runs.filter((text) => text.startsWith('run-'))) expect(more).toContain(one);
    remove();
  });
});
