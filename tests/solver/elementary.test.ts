import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { exponential, logarithm, normalQuantile } from '../../solver/measure/player/elementary.ts';
import { normalBeyondHalf } from '../../solver/measure/robustness/index.ts';

describe('the portable exponential and logarithm', () => {
  it('agree with those of the machine', () => {
    fc.assert(
      fc.property(fc.double({ min: -700, max: 700, noNaN: true }), (x) => {
        expect(Math.abs(exponential(x) / Math.exp(x) - 1)).toBeLessThan(1e-13);
      }),
    );
    fc.assert(
      fc.property(fc.double({ min: 1e-300, max: 1e300, noNaN: true }), (x) => {
        expect(Math.abs(logarithm(x) - Math.log(x))).toBeLessThan(1e-13 * Math.max(1, Math.abs(Math.log(x))));
      }),
    );
    expect([exponential(0), logarithm(1)]).toEqual([1, 0]);
  });
});

describe('the normal quantile', () => {
  it('inverts the distribution function', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-9, max: 1 - 1e-9, noNaN: true }), (p) => {
        expect(Math.abs(0.5 + normalBeyondHalf(normalQuantile(p)) - p)).toBeLessThan(1e-6);
      }),
    );
    // beyond 5 on the scale of its tail, where the distribution function above is no longer exact: tabulated
    expect(normalQuantile(1e-12)).toBeCloseTo(-7.0344838, 5);
    expect(normalQuantile(0.95)).toBeCloseTo(1.6448536, 6);
  });
});
