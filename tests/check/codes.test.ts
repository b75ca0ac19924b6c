import { describe, expect, it } from 'vitest';
import { type Findings, problemsOf } from '../../check/index.ts';
import type { CheckCode } from '../../check/words/index.ts';
import { commandHints } from '../../cli/check/check-level.ts';
import { crashedLevel, unreadableLevel } from '../../cli/check/checked-level.ts';
import { CHECK_CODES } from '../../cli/check/codes.ts';
import { shellPath } from '../../cli/terminal/messages.ts';
import { PAGE_HINTS } from '../../editor/core/proof/known-problems.ts';
import { explanationOf } from '../../editor/features/problems/explanations.tsx';
import { ACCURACIES, DEFAULT_MAX_TIME, DEFAULT_TERMS, WARNING_CODES } from '../../engine/index.ts';
import { CODES, resolveLevel } from '../../schema/index.ts';
import { type Proof, proveImpossible, proveMineralsUnreachable } from '../../solver/index.ts';
import { gq } from '../cli/gq.ts';

const all = [...CHECK_CODES, ...CODES, ...WARNING_CODES];

const far = resolveLevel({
  version: 1,
  name: 'far',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 9000, y: 0 },
  asteroids: [{ x: 100, y: 0, radius: 16 }],
  minerals: [{ x: 0, y: 9000 }],
});
const impossible = proveImpossible(far);
const [unreachable] = proveMineralsUnreachable(far);

const NOTHING: Findings = {
  accuracy: ACCURACIES.precise.name,
  range: 250,
  ends: [],
  collected: [],
  allow: {},
  hangs: [],
  warnings: [],
  cuts: { runs: null, accuracies: null, nearness: null },
  impossible: null,
  lost: [],
  searched: null,
  tight: [],
  softlocks: null,
  sought: { slack: null, minerals: false, softlocks: false },
};
const DRIFT = { name: 'drift', outcome: 'timeout', with: null, time: DEFAULT_MAX_TIME, tick: 3600, isStopped: false } as const;
const THROUGH = { ...DRIFT, name: 'through', outcome: 'completed', time: 2, tick: 120 } as const;
const TIGHT = {
  holds: [[1, 2]],
  name: 'run "through"',
  pointer: '/runs/0',
  ticks: 0,
  counterexample: [[1, 3]],
  isExhausted: false,
} as const;
const SOFTLOCKS: NonNullable<Findings['softlocks']> = {
  states: { examined: 2, open: 1, proved: 1, notFound: 0, unknown: 0 },
  lasting: { proved: 1, notFound: 0 },
  places: [
    {
      ...{ x: 1, y: 2, tick: 60, holds: [], open: 50, alive: 400, states: 1, run: null },
      standing: { is: 'proved', proof: impossible as Proof },
    },
  ],
  effort: { runs: 1, ticks: 1 },
  isFinished: true,
};
const EFFORT = { runs: 3, ticks: 400 };

/** Codes of files that are no levels, and of what a lock or the order of a pack says about levels. */
const OF_FILES = [
  ...(['unreadable-file', 'crashed', 'result-changed', 'not-in-lock', 'pack-missing-level', 'pack-repeated-level'] as const),
  ...(['pack-unlisted-level', 'pack-introduction', 'pack-empty-chapter'] as const),
] as const;

/** For each code that a check of a level can report, what must be found for it. */
const FOUND: Readonly<Record<Exclude<CheckCode, (typeof OF_FILES)[number]>, Partial<Findings>>> = {
  'run-does-not-complete': { ends: [DRIFT] },
  'no-run': {},
  'found-run': { searched: { found: [[4, 9]], effort: EFFORT, closest: null } },
  'no-run-found': { searched: { found: null, effort: EFFORT, closest: { distance: 12.34, tick: 30, holds: [[4, 9]] } } },
  'proved-impossible': { impossible },
  'mineral-never-collectable': { ends: [THROUGH], lost: [{ index: 0, proof: unreachable }] },
  softlock: { ends: [THROUGH], softlocks: SOFTLOCKS },
  'low-slack': { ends: [THROUGH], tight: [{ ...TIGHT, required: null }] },
  'slack-below-required': { ends: [THROUGH], tight: [{ ...TIGHT, required: 2 }] },
  'verdict-hangs-on-accuracy': {
    ends: [THROUGH],
    hangs: [
      {
        index: 0,
        name: 'through',
        ends: [
          { accuracy: 'precise', end: THROUGH },
          { accuracy: 'arcade', end: DRIFT },
        ],
      },
    ],
  },
  'unused-allow': { ends: [THROUGH], allow: { 'same-place': 'meant' } },
  'work-limit': { ends: [{ ...DRIFT, isStopped: true }], cuts: { ...NOTHING.cuts, runs: { maxWork: 9, of: 'work' } } },
};

describe('every code that a check can report', () => {
  it.each(Object.entries(FOUND))('%s is reported alone where it is found, and is explained', (code, found) => {
    const problems = problemsOf({ ...NOTHING, ...found }, commandHints(shellPath('a b.level.json')));
    expect(problems.map((problem) => problem.code)).toEqual([code]);
    const explanation = all.find((entry) => entry.code === code);
    expect(problems[0].severity).toBe(explanation?.severity);
    expect(problems[0].message).not.toMatch(/undefined|\[object/);
    expect(problems[0].hint).not.toBe('');
  });

  it('codes of files that are no levels are explained, too', () => {
    const explained = all.map(({ code }) => code);
    const [unreadable] = unreadableLevel('a.level.json', 'no such file', DEFAULT_TERMS).problems;
    const [crashed] = crashedLevel('a.level.json', new Error('bug'), DEFAULT_TERMS).problems;
    expect([unreadable.code, crashed.code]).toEqual(['unreadable-file', 'crashed']);
    for (const { code } of [unreadable, crashed]) expect(explained).toContain(code);
    // Nothing else is explained than what is listed above.
    expect(CHECK_CODES.map(({ code }) => code).sort()).toEqual([...Object.keys(FOUND), ...OF_FILES].sort());
  });

  it('is explained once, under a title that continues "code (error):"', () => {
    expect(new Set(all.map(({ code }) => code)).size).toBe(all.length);
    for (const { code, title, why, fix } of all) {
      expect(code).toMatch(/^[a-z0-9]+(-[a-z0-9]+)*$/);
      // It begins with a small letter, except for a word that is always written so (NaN).
      expect(title, code).toMatch(/^(?:[a-z]|\w+[A-Z]).*[^.]$/s);
      expect(why, code).toMatch(/\.$/);
      expect(fix, code).toMatch(/[.:`)]$/);
    }
  });

  const oneLine = (text: string) => text.replaceAll(/\s+/g, ' ');

  it.each(all)('$code is what gq explain shows', async ({ code, severity, title, why, fix }) => {
    const [pretty, json] = await Promise.all([gq(['explain', code]), gq(['explain', code, '--format', 'json'])]);
    expect([pretty.code, json.code]).toEqual([0, 0]);
    expect(pretty.stdout.split('\n')[0]).toBe(`${code} (${severity}): ${title}`);
    expect(oneLine(pretty.stdout)).toContain(oneLine(why));
    expect(oneLine(pretty.stdout)).toContain(`How to fix it ${oneLine(fix)}`);
    expect(JSON.parse(json.stdout)).toMatchObject({ code, severity, title, why, fix });
  });
});

describe('the page', () => {
  const told = Object.entries(FOUND).filter(
    ([, { searched, tight, softlocks }]) => searched === undefined && tight === undefined && softlocks === undefined,
  );

  it.each(told)('explains %s, which it can report, by the same reasons, and has its own hints', (code, found) => {
    const [there] = problemsOf({ ...NOTHING, ...found }, commandHints('a.level.json'));
    const [here] = problemsOf({ ...NOTHING, ...found }, PAGE_HINTS);
    expect({ ...here, hint: '' }).toEqual({ ...there, hint: '' });
    expect(here.hint).not.toMatch(/\bgq\b|--/);
    const byCommand = CHECK_CODES.find((entry) => entry.code === code);
    const onPage = explanationOf(code);
    expect([onPage?.title, onPage?.severity]).toEqual([byCommand?.title, byCommand?.severity]);
    expect(onPage?.why.slice(0, 60)).toBe(byCommand?.why.slice(0, 60));
    expect(onPage?.fix).not.toMatch(/\bgq\b|--/);
  });
});
