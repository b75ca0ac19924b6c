import { describe, expect, test } from 'vitest';
import type * as z from 'zod';
import {
  type CheckReport,
  checkReportSchema,
  difficultyReportSchema,
  generateReportSchema,
  type RunReport,
  robustnessReportSchema,
  runReportSchema,
  solveReportSchema,
  VERDICTS,
} from '../../schema/index.ts';

const terms = { accuracy: 'precise', maxTime: 120, maxWork: 400_000, rules: { pull: 42 } };

const run: RunReport = {
  level: 'levels/01-first-swing.level.json',
  accuracy: 'precise',
  terms,
  holds: [[12, 96]],
  outcome: 'collided',
  with: { kind: 'nova', index: 0 },
  time: 3.25,
  tick: 195,
  minerals: [{ index: 1, time: 1.5 }],
  events: [
    { time: 0.2, type: 'press' },
    { time: 0.2, type: 'target', index: 0 },
  ],
  clearance: { distance: 0, kind: 'nova', index: 0, time: 3.25 },
  final: { x: 1, y: 2, vx: 3, vy: 4, angle: -1 },
  samples: [[0, 1, 2, 0, 0, 0]],
  hash: '9f3c2a',
};

const report: CheckReport = {
  version: 1,
  levels: [
    { file: 'a.level.json', name: 'A', terms, verdict: 'broken', run, problems: [], failure: null, ms: 1.5 },
    {
      file: 'b.level.json',
      name: 'b.level.json',
      terms,
      verdict: 'invalid',
      run: null,
      problems: [{ code: 'empty-file', severity: 'error', message: 'the file is empty', line: 1, column: 1, pointer: '' }],
      failure: { command: 'gq edit --open b.level.json', link: null, tick: null },
      ms: 0,
    },
  ],
  summary: { broken: 1, invalid: 1 },
  interrupted: false,
  unchecked: [],
};

describe('the JSON of reports', () => {
  test('accepts a run and a check of the promised shape unchanged', () => {
    expect(runReportSchema.parse(run)).toEqual(run);
    expect(checkReportSchema.parse(report)).toEqual(report);
    const everyVerdict = Object.fromEntries(VERDICTS.map((verdict) => [verdict, 0]));
    expect(checkReportSchema.safeParse({ ...report, summary: everyVerdict }).success).toBe(true);
    expect(runReportSchema.safeParse({ ...run, with: null, clearance: null }).success).toBe(true);
  });

  test.each([
    ['a key more', { ...run, extra: 1 }],
    ['an unknown outcome', { ...run, outcome: 'won' }],
    ['NaN', { ...run, time: Number.NaN }],
    ['a sample without the angle', { ...run, samples: [[0, 1, 2, 0, 0]] }],
    ['an event without a time', { ...run, events: [{ type: 'press' }] }],
  ])('refuses %s in a run', (_, wrong) => {
    expect(runReportSchema.safeParse(wrong).success).toBe(false);
  });

  test('refuses a missing key and an unknown verdict', () => {
    for (const key of Object.keys(run)) {
      expect(runReportSchema.safeParse(Object.fromEntries(Object.entries(run).filter(([k]) => k !== key))).success).toBe(false);
    }
    expect(checkReportSchema.safeParse({ ...report, summary: { fine: 1 } }).success).toBe(false);
  });
});

// every number at its minimum, and -7 if there is none
const robustness = {
  ...{ p30: 0, p40: 0, p60: 0, p80: 0, certifiedTicks: 0, decided: false, slack: [[0, 0]], samples: 0 },
  intervals: { p30: [0, 0], p40: [0, 0], p60: [0, 0], p80: [0, 0] },
};
const place = { kind: 'nova', index: 0 };
const leastTerms = { accuracy: '', maxTime: 0, maxWork: 1, rules: {} };
const leastRun = {
  terms: leastTerms,
  ...{ level: '', accuracy: '', holds: [[-7, -7]], outcome: 'lost', with: place, time: 0, tick: 0 },
  minerals: [{ index: 0, time: 0 }],
  events: [{ time: 0, type: '' }],
  clearance: { distance: -7, ...place, time: 0 },
  final: { x: -7, y: -7, vx: -7, vy: -7, angle: -7 },
  samples: [Array(6).fill(-7)],
  hash: '',
};
const found = { holds: [[-7, -7]], time: 0, tick: 0, minerals: [0] };
const solution = {
  terms: leastTerms,
  ...{ level: '', accuracy: '', found: false, holds: null, outcome: null, time: 0, tick: 0, minerals: [{ index: 0, time: 0 }] },
  effort: { runs: 0, ticks: 0, seconds: 0, seed: -7 },
  robustness,
  closest: { distance: 0, tick: 0, holds: [] },
  impossible: null,
  hash: null,
};
const ofPlayers = { p: 0, low: 0, high: 0 };
const forecast = {
  parameters: { motorMs: 0, weber: 0, reactionMs: 0, lookaheadMs: 0, planMs: 0, learning: 0, scale: 0, spread: 0 },
  ...{ firstErrorMs: 0, lastErrorMs: 0, players: 0 },
  attempts: [{ number: 1, pass: ofPlayers, range: [0, 0], solved: ofPlayers }],
  ...{ half: 1, most: 1 },
};
const measured = {
  run: { name: null, ...found },
  grade: { value: 1, word: '' },
  comparison: { runs: [{ name: null, ...found, p40: 0, sigmaAtHalf: 0, grade: 1 }], meanP40: 0, meanGrade: 1 },
  robustness,
  sigmaAtHalf: { ms: -7, low: -7, high: -7, capped: true },
  ...{ smallestWindow: 0, presses: 0, length: 0 },
  randomPlay: { share: 0, low: 0, high: 0, samples: -7 },
  mineralsExtra: { run: found, time: -7, presses: -7, p40: -7 },
  shortcuts: {
    withoutPressing: found,
    onePress: { count: -7, tried: -7, length: -7, stride: 1, example: null },
    withoutAsteroid: [{ asteroid: 0, use: 'unknown', run: null }],
  },
  forecast,
  curve: [{ sigma: -7, p: 0, low: 0, high: 0, samples: -7 }],
};
const generated = {
  ...{ seed: -7, status: 'nothing', file: null, name: null, grade: { value: -7, word: '' }, p40: 0, certifiedTicks: -7 },
  ...{ length: 0, presses: -7, attempts: -7, ticks: -7, aside: -7 },
  theme: { name: '', measured: '', value: -7, least: -7 },
  symmetry: { kind: '', share: 0 },
};
const problem = { code: '', severity: 'error', message: '', line: 1, column: 1, pointer: '' };
const checked = {
  file: '',
  name: '',
  terms: leastTerms,
  verdict: 'invalid',
  run: leastRun,
  problems: [problem],
  failure: { command: '', link: null, tick: 0 },
  ms: 0,
};
const version = { version: 1 };
const early = { interrupted: false, unchecked: [''] };

/** The path of every number in a value. */
function* numbersIn(value: unknown, path: readonly string[] = []): Generator<readonly string[]> {
  if (typeof value === 'number') yield path;
  else if (typeof value === 'object' && value !== null)
    for (const [key, inner] of Object.entries(value)) yield* numbersIn(inner, [...path, key]);
}
/** A copy with the number at a path changed. */
function withNumber(value: unknown, [key, ...rest]: readonly string[], change: (old: number) => number): unknown {
  if (key === undefined) return change(value as number);
  const inner = withNumber((value as Record<string, unknown>)[key], rest, change);
  if (Array.isArray(value)) return value.with(Number(key), inner);
  return { ...(value as object), [key]: inner };
}

describe.each<[name: string, schema: z.ZodType, least: object]>([
  ['a run', runReportSchema, leastRun],
  ['check', checkReportSchema, { ...version, levels: [checked], summary: { invalid: 0 }, ...early }],
  ['robustness', robustnessReportSchema, robustness],
  ['solve', solveReportSchema, { ...version, ...solution, solutions: [solution] }],
  [
    'difficulty',
    difficultyReportSchema,
    { ...version, levels: [{ file: '', name: '', terms: leastTerms, problems: [problem], measured, why: null }] },
  ],
  [
    'generate',
    generateReportSchema,
    {
      ...version,
      asked: 1,
      levels: [generated],
      terms: leastTerms,
      rejected: 0,
      reasons: { noRun: 0 },
      variety: { mean: 0, closest: { distance: 0, seeds: [-2, -1] } },
    },
  ],
])('the numbers of %s', (_, schema, least) => {
  test('may be at their minimum, and not below; shares are at most 1, and a grade at most 10', () => {
    expect(schema.safeParse(least)).toMatchObject({ success: true });
    for (const path of numbersIn(least)) {
      const takes = (change: (old: number) => number) => schema.safeParse(withNumber(least, path, change)).success;
      if (path.join() === 'version') {
        expect(takes((old) => old + 1)).toBe(false);
        continue;
      }
      const isFree = takes((old) => (old < 0 ? old - 1 : Number.NaN));
      expect([path, takes((old) => old - 1)]).toEqual([path, isFree]);
      const most =
        /^(p\d\d|p|share|low|high|meanP40)$/.test(path.at(-1) ?? '') ||
        ['intervals', 'range', 'variety'].some((key) => path.includes(key))
          ? 1
          : 10;
      if (isFree) continue;
      expect([path, takes(() => most)]).toEqual([path, true]);
      if (most === 1 || path.includes('grade')) expect([path, takes(() => most + 1)]).toEqual([path, false]);
    }
  });

  test('are whole if they are counts', () => {
    for (const path of numbersIn(least)) {
      const counts =
        /^(tick|ticks|index|line|column|runs|certifiedTicks|samples|asked|rejected|stride|asteroid|attempts|smallestWindow|seed|presses|count|tried|players|number|half|most)$/;
      if (counts.test(path.at(-1) ?? ''))
        expect([path, schema.safeParse(withNumber(least, path, () => 1.5)).success]).toEqual([path, false]);
    }
  });
});
