import { describe, expect, test } from 'vitest';
import { type CheckReport, checkReportSchema, type RunReport, runReportSchema, VERDICTS } from '../../schema/index.ts';

const run: RunReport = {
  level: 'levels/01-first-swing.level.json',
  accuracy: 'precise',
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
  levels: [
    { file: 'a.level.json', name: 'A', verdict: 'broken', run, problems: [], ms: 1.5 },
    {
      file: 'b.level.json',
      name: 'b.level.json',
      verdict: 'invalid',
      run: null,
      problems: [{ code: 'empty-file', severity: 'error', message: 'the file is empty', line: 1, column: 1, pointer: '' }],
      ms: 0,
    },
  ],
  summary: { broken: 1, invalid: 1 },
};

describe('the JSON of reports', () => {
  test('a run and a check of the promised shape are accepted as they are', () => {
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
  ])('%s is refused in a run', (_, wrong) => {
    expect(runReportSchema.safeParse(wrong).success).toBe(false);
  });

  test('a key less and an unknown verdict are refused', () => {
    for (const key of Object.keys(run)) {
      expect(runReportSchema.safeParse(Object.fromEntries(Object.entries(run).filter(([k]) => k !== key))).success).toBe(false);
    }
    expect(checkReportSchema.safeParse({ ...report, summary: { fine: 1 } }).success).toBe(false);
  });
});
