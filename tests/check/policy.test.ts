import { describe, expect, it } from 'vitest';
import { applyPolicy } from '../../check/index.ts';
import { CHECK_CODES } from '../../cli/check/codes.ts';
import type { CheckedLevel } from '../../cli/check/index.ts';
import { exitCodeOf } from '../../cli/check/index.ts';
import { WARNING_CODES } from '../../engine/index.ts';
import {
  ADJUSTABLE_CODES,
  ADJUSTMENTS,
  ALLOWABLE_CODES,
  adjustmentOf,
  CODES,
  type SeverityMap,
  VERDICTS,
} from '../../schema/index.ts';
import * as fc from '../fast-check.ts';

const listed = [...CHECK_CODES, ...WARNING_CODES];
const all = [...listed, ...CODES];

const severities: fc.Arbitrary<SeverityMap> = fc
  .dictionary(fc.constantFrom(...ADJUSTABLE_CODES), fc.constantFrom('error', 'warning', 'off'))
  .map((map) => map as SeverityMap);
const allows = fc.dictionary(fc.constantFrom(...ALLOWABLE_CODES), fc.constant('meant'));
const problems = fc.array(
  fc.record({
    code: fc.constantFrom(...all.map(({ code }) => code)),
    severity: fc.constantFrom('error' as const, 'warning' as const),
  }),
  { maxLength: 8 },
);

describe('the policy', () => {
  it('knows every code that a check can report, and no other', () => {
    expect(Object.keys(ADJUSTMENTS).sort()).toEqual(listed.map(({ code }) => code).sort());
    for (const { code } of CODES) expect(adjustmentOf(code), code).toEqual({ severity: 'fixed', allow: false });
    expect(adjustmentOf('toString')).toBeNull();
  });

  it('gives every warning a severity that can be changed, and the errors that decide a verdict none', () => {
    for (const { code, severity } of listed) {
      if (severity === 'warning') expect(adjustmentOf(code)?.severity, code).toBe('free');
    }
    for (const code of ['no-run', 'no-run-found', 'proved-impossible', 'unreadable-file', 'crashed', 'wrong-type'])
      expect(adjustmentOf(code)?.severity, code).toBe('fixed');
  });

  it('keeps the order, invents nothing, and counts what is allowed', () => {
    fc.assert(
      fc.property(problems, severities, allows, (found, severity, allow) => {
        const { problems: kept, allowed } = applyPolicy(found, { severity, allow });
        let at = -1;
        for (const { code } of kept) {
          at = found.findIndex((problem, i) => i > at && problem.code === code);
          expect(at).toBeGreaterThanOrEqual(0);
        }
        const off = kept.length + allowed - found.length;
        expect(off).toBeLessThanOrEqual(0);
        for (const { code } of kept) if (Object.hasOwn(allow, code)) expect(adjustmentOf(code)?.severity, code).toBe('warnings');
        expect(applyPolicy(found, { severity: {}, allow: {} })).toEqual({ problems: found, allowed: 0 });
      }),
    );
  });

  it('never makes a level green that is not completable or has an error that decides', () => {
    const level = fc.record({ verdict: fc.constantFrom(...VERDICTS), problems });
    fc.assert(
      fc.property(fc.array(level, { minLength: 1, maxLength: 4 }), severities, allows, (levels, severity, allow) => {
        const judged = levels.map((one) => {
          const { problems: kept } = applyPolicy(one.problems, { severity, allow });
          return { verdict: one.verdict, problems: kept, unreadable: false } as unknown as CheckedLevel;
        });
        if (exitCodeOf(judged, null) !== 0) return;
        for (const { verdict, problems: found } of levels) {
          expect(verdict).toBe('completable');
          for (const { code, severity: before } of found)
            if (before === 'error') expect(adjustmentOf(code)?.severity).toBe('free');
        }
        for (const { problems: kept } of judged) for (const problem of kept) expect(problem.severity).toBe('warning');
      }),
    );
  });

  it('applies what is said', () => {
    const found = [
      { code: 'same-place', severity: 'warning' },
      { code: 'overlapping', severity: 'warning' },
      { code: 'low-slack', severity: 'warning' },
      { code: 'run-does-not-complete', severity: 'warning' },
      { code: 'run-does-not-complete', severity: 'error' },
      { code: 'slack-below-required', severity: 'error' },
    ] as const;
    const severity = {
      'same-place': 'error',
      overlapping: 'off',
      'run-does-not-complete': 'off',
      'slack-below-required': 'warning',
    } as const;
    expect(applyPolicy(found, { severity, allow: { 'low-slack': 'for experts' } })).toEqual({
      problems: [
        { code: 'same-place', severity: 'error' },
        { code: 'run-does-not-complete', severity: 'error' },
        { code: 'slack-below-required', severity: 'warning' },
      ],
      allowed: 1,
    });
  });
});
