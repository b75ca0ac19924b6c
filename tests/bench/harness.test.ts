import { describe, expect, it } from 'vitest';
import { atLeast, atMost, compare, figure, keeps, spread } from '../../bench/harness/index.ts';

describe('harness', () => {
  it('takes quartiles between ranks', () => {
    expect(spread([4, 1, 3, 2])).toEqual({ median: 2.5, q1: 1.75, q3: 3.25 });
    expect(spread([7])).toEqual({ median: 7, q1: 7, q3: 7 });
  });

  it('lets contestants take turns, each once a round, and each first in its turn', () => {
    const order: string[] = [];
    const contestant = (name: string) => ({ name, run: () => order.push(name) });
    const { samples } = compare([contestant('a'), contestant('b'), contestant('c')], { rounds: 15, sampleMs: 0, warmUpMs: 0 });
    expect(Object.values(samples).map((s) => s.length)).toEqual([15, 15, 15]);
    const counted = order.slice(-45);
    expect(counted.slice(0, 9).join('')).toBe('abcbcacab');
  });

  it('does not time what prepares a run', () => {
    let prepared = 0;
    let ran = 0;
    const contestant = { name: 'a', prepare: () => prepared++, run: () => ran++ };
    compare([contestant, { name: 'b', run: () => 0 }], { rounds: 15, sampleMs: 0, warmUpMs: 0 });
    expect(prepared).toBe(ran);
  });

  it('refuses comparisons that would mean little', () => {
    const one = { name: 'a', run: () => 0 };
    expect(() => compare([one])).toThrow(/at least two/);
    expect(() => compare([one, one], { rounds: 3 })).toThrow(/at least 15/);
  });

  it('holds a claim to its limit, and a measurement that is no number to none', () => {
    expect(keeps(atMost(1.3, 'a'), 1.3)).toBe(true);
    expect(keeps(atMost(1.3, 'a'), 1.31)).toBe(false);
    expect(keeps(atMost(1.3, 'a'), Number.NaN)).toBe(false);
    expect(keeps(atLeast(0.7, 'a'), 0.7)).toBe(true);
    expect(keeps(atLeast(0.7, 'a'), 0.69)).toBe(false);
    expect(keeps(atLeast(0.7, 'a'), Number.NaN)).toBe(false);
  });

  it('prints four figures', () => {
    expect([0, 1234.5678, 0.98765, 1.5e-9].map(figure)).toEqual(['0', '1235', '0.9877', '1.50e-9']);
  });
});
