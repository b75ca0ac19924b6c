import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Findings, onceProved, problemsOf, unproved, verdictOfFindings } from '../../check/index.ts';
import { commandHints } from '../../cli/check/check-level.ts';
import { PAGE_HINTS } from '../../editor/core/proof/known-problems.ts';
import { findWarnings, type Outcome } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { proveImpossible, proveMineralsUnreachable } from '../../solver/index.ts';

const far = resolveLevel({
  version: 1,
  name: 'far',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 9000, y: 0 },
  asteroids: [{ x: 100, y: 0, radius: 16 }],
  minerals: [
    { x: 0, y: 9000 },
    { x: 0, y: 9100 },
  ],
  runs: [{ name: 'drift', holds: [] }],
});
const impossible = proveImpossible(far);
if (impossible === null) throw new Error('expected a proof');
const lost = proveMineralsUnreachable(far).map((proof, index) => ({ index, proof }));
const warnings = findWarnings(far, []);

const end = fc.record({
  name: fc.string({ maxLength: 4 }),
  outcome: fc.constantFrom<Outcome>('completed', 'collided', 'lost', 'timeout'),
  with: fc.constant(null),
  time: fc.constant(2),
  tick: fc.constant(120),
  isStopped: fc.boolean(),
});
const overrun = fc.record({ maxWork: fc.nat(), of: fc.constantFrom('work' as const, 'memory' as const) });
const searched = fc.record({
  found: fc.constantFrom(null, [[3, 9]] as const),
  effort: fc.constant({ runs: 3, ticks: 400 }),
  closest: fc.constantFrom(null, { distance: 12.3, tick: 40, holds: [[1, 2]] as const }),
});

/** Everything that a check can find and that does not contradict itself. */
const findings: fc.Arbitrary<Findings> = fc
  .record({
    ends: fc.array(end, { maxLength: 4 }),
    isImpossible: fc.boolean(),
    searched: fc.option(searched),
    lost: fc.subarray(lost),
    warnings: fc.subarray(warnings),
    runs: overrun,
    accuracies: fc.option(overrun),
    nearness: fc.option(overrun),
  })
  .map(({ ends, isImpossible, searched: search, runs, accuracies, nearness, ...more }) => {
    // A run that was stopped has completed nothing.
    const played = ends.map((one) => (one.isStopped ? { ...one, outcome: 'timeout' as const } : one));
    const completes = played.some(({ outcome }) => outcome === 'completed');
    return {
      ...unproved,
      ...more,
      accuracy: 'precise',
      range: 250,
      collected: [],
      allow: {},
      hangs: [],
      ends: played,
      cuts: { runs: played.some(({ isStopped }) => isStopped) ? runs : null, accuracies, nearness },
      // A level that a run has completed is not proved impossible, and nothing is searched for where a run is known.
      impossible: completes || !isImpossible ? null : impossible,
      searched: completes || isImpossible ? null : search,
    };
  });

describe('the problems of a level', () => {
  it('include an error for every verdict but completable, and none for that one', () => {
    fc.assert(
      fc.property(findings, (found) => {
        const errors = problemsOf(found, commandHints('a.level.json')).filter(({ severity }) => severity === 'error');
        expect(errors.length > 0).toBe(verdictOfFindings(found) !== 'completable');
      }),
    );
  });

  it('begin with what decides the verdict, and end with warnings', () => {
    const looked = new Set(warnings.map(({ code }) => code));
    fc.assert(
      fc.property(findings, (found) => {
        const codes = problemsOf(found, PAGE_HINTS).map(({ code }) => code);
        const first = codes.findIndex((code) => looked.has(code));
        if (first >= 0) expect(codes.slice(first).every((code) => looked.has(code))).toBe(true);
        for (const code of ['proved-impossible', 'no-run', 'no-run-found', 'found-run'])
          expect(codes.lastIndexOf(code)).toBeLessThanOrEqual(0);
      }),
    );
  });

  it('are no longer guessed once they are proved', () => {
    expect(warnings.map(({ code }) => code)).toEqual(expect.arrayContaining(['black-hole-out-of-reach', 'mineral-out-of-reach']));
    fc.assert(
      fc.property(findings, (found) => {
        const problems = problemsOf(found, PAGE_HINTS);
        const proved = problems.filter(({ code }) => code === 'mineral-never-collectable').map(({ pointer }) => pointer);
        expect(proved).toEqual(found.lost.map(({ index }) => `/minerals/${index}`));
        for (const { code, pointer } of problems) {
          if (code === 'mineral-out-of-reach') expect(proved).not.toContain(pointer);
          if (code === 'black-hole-out-of-reach') expect(found.impossible).toBeNull();
        }
      }),
    );
  });

  it('a verdict that was given before anything was proved is the same afterwards', () => {
    fc.assert(
      fc.property(findings, (found) => {
        const before = verdictOfFindings({ ...found, impossible: null });
        expect(onceProved(before, found.impossible !== null)).toBe(verdictOfFindings(found));
      }),
    );
  });
});
