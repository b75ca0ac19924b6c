import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Hash } from '../../engine/hash.ts';
import { itQuick } from '../depth.ts';

const hashOf = (values: ArrayLike<number>) => {
  const hash = new Hash();
  for (let i = 0; i < values.length; i++) hash.add(values[i]);
  return hash.digest();
};

// any bits but those of NaN, whose bits JavaScript doesn't promise to keep
const doubles = fc.array(fc.double({ noNaN: true }), { minLength: 1, maxLength: 40 });

describe('hash', () => {
  it('is 16 hexadecimal digits', () => {
    fc.assert(
      fc.property(doubles, (values) => {
        expect(hashOf(values)).toMatch(/^[0-9a-f]{16}$/);
      }),
    );
  });

  it('changes with any single bit of any number', () => {
    fc.assert(
      fc.property(doubles, fc.nat(), fc.nat(63), (values, place, bit) => {
        const changed = Float64Array.from(values);
        const bits = new BigUint64Array(changed.buffer);
        bits[place % values.length] ^= 1n << BigInt(bit);
        fc.pre(!changed.some(Number.isNaN));
        expect(hashOf(changed)).not.toBe(hashOf(values));
      }),
      { numRuns: 2000 },
    );
  });

  it('distinguishes -0 from 0, different orders, and an additional 0', () => {
    expect(hashOf([-0])).not.toBe(hashOf([0]));
    expect(hashOf([1, 2])).not.toBe(hashOf([2, 1]));
    expect(hashOf([1, 0])).not.toBe(hashOf([1]));
    expect(hashOf([0])).not.toBe(hashOf([]));
  });

  it('distinguishes where one text ends and the next begins', () => {
    const textHash = (...texts: string[]) => {
      const hash = new Hash();
      for (const text of texts) hash.addText(text);
      return hash.digest();
    };
    expect(textHash('ab', 'c')).not.toBe(textHash('a', 'bc'));
    expect(textHash('lost')).not.toBe(textHash('tsol'));
  });

  itQuick('has no collision among 100,000 neighbours', () => {
    const seen = new Set<string>();
    for (let i = 0; i < 100_000; i++) seen.add(hashOf([1 + i * Number.EPSILON, 0.5]));
    expect(seen.size).toBe(100_000);
  });

  it('does not change: otherwise every committed hash is void', () => {
    expect(hashOf([1, -0, 1 / 3, 1e300])).toMatchInlineSnapshot(`"1f1205bb1857c852"`);
  });
});
