import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../solver/index.ts';
import {
  drawShift,
  extremeNoise,
  normalBeyondHalf,
  shiftHolds,
  tickNoise,
  uniformOf,
} from '../../../solver/measure/robustness/index.ts';
import { wilsonInterval } from '../../../solver/measure/robustness/success-probability.ts';
import { arbitraryHolds } from '../../engine/arbitrary-level.ts';

describe('the normal distribution', () => {
  // P(0 < X < x), erf(x / sqrt 2) / 2 computed with 40 digits by mpmath.
  it.each([
    [0.5, 0.1914624612740131],
    [1, 0.3413447460685429],
    [2, 0.4772498680518208],
    [3, 0.4986501019683699],
    [4.5, 0.49999660232687526],
    [6.2, 0.4999999997176842],
  ])('up to %f', (x, expected) => {
    expect(Math.abs(normalBeyondHalf(x) - expected)).toBeLessThan(1e-14);
    expect(normalBeyondHalf(-x)).toBe(-normalBeyondHalf(x));
  });
});

describe('noise in ticks', () => {
  it.each([0, 1, 4, 15, 30, 40, 60, 80])('of %i ms is a distribution with the right spread', (sigma) => {
    const { probability, reach, upTo } = tickNoise(sigma);
    let [sum, mean, square] = [0, 0, 0];
    probability.forEach((p, i) => {
      sum += p;
      mean += p * (i - reach);
      square += p * (i - reach) ** 2;
    });
    const ticks = (sigma * 60) / 1000;
    expect(sum).toBeCloseTo(1, 12);
    expect(Math.abs(mean)).toBeLessThan(1e-12);
    // Rounding to whole ticks adds 1/12 once the noise spans several of them.
    if (ticks > 0.8) expect(square).toBeCloseTo(ticks * ticks + 1 / 12, 2);
    if (sigma === 0) expect(probability).toEqual(Float64Array.of(1));
    expect(upTo[upTo.length - 1]).toBe(2 ** 32);
    for (let i = 1; i < upTo.length; i++) expect(upTo[i]).toBeGreaterThanOrEqual(upTo[i - 1]);
  });

  it.each([tickNoise(40), extremeNoise(2)])('is drawn as often as it should be', (noise) => {
    const seen = new Float64Array(noise.probability.length);
    const draws = 40_000;
    for (let i = 0; i < draws; i++) seen[drawShift(noise, uniformOf(7, i >> 3, i & 7)) + noise.reach]++;
    noise.probability.forEach((p, i) => {
      expect(Math.abs(seen[i] - p * draws)).toBeLessThanOrEqual(4.5 * Math.sqrt(draws * p * (1 - p)) + 1);
    });
  });

  it('is the same everywhere: numbers are mixed like the finalizer of MurmurHash3', () => {
    const bits = (n: bigint) => BigInt.asUintN(32, n);
    const mixed = (value: bigint): bigint => {
      let h = bits(value);
      h = bits((h ^ (h >> 16n)) * 0x85ebca6bn);
      h = bits((h ^ (h >> 13n)) * 0xc2b2ae35n);
      return h ^ (h >> 16n);
    };
    // As published.
    expect([mixed(0n), mixed(1n)]).toEqual([0n, 0x514e28b7n]);
    fc.assert(
      fc.property(fc.nat(2 ** 31 - 1), fc.nat(5000), fc.nat(40), (seed, sample, edge) => {
        const bySeed = mixed(BigInt(seed) ^ 0x9e3779b9n);
        const bySample = mixed(bySeed ^ bits(BigInt(sample + 1) * 0x85ebca6bn));
        expect(BigInt(uniformOf(seed, sample, edge))).toBe(mixed(bySample + BigInt(edge + 1) * 0xc2b2ae35n));
      }),
    );
  });

  it('of extremes is one shift or the other, each for half of the numbers', () => {
    for (const ticks of [1, 2, 7]) {
      const noise = extremeNoise(ticks);
      expect([0, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1].map((n) => drawShift(noise, n))).toEqual([-ticks, -ticks, ticks, ticks]);
      expect(noise.probability.reduce((sum, p) => sum + p)).toBe(1);
    }
  });

  it('is independent between edges and samples', () => {
    const noise = tickNoise(40);
    const shift = (sample: number, edge: number) => drawShift(noise, uniformOf(3, sample, edge));
    for (const [samples, edges] of [
      [0, 1],
      [1, 0],
      [1, 1],
    ]) {
      let product = 0;
      for (let i = 0; i < 20_000; i++) product += shift(i, 2) * shift(i + samples, 2 + edges);
      // Variance 2.4² + 1/12 each.
      expect(Math.abs(product / 20_000)).toBeLessThan((4.5 * 5.85) / Math.sqrt(20_000));
    }
  });
});

describe("Wilson's interval", () => {
  it('contains the truth about 95 times in 100', () => {
    const random = createRandom(1);
    for (const p of [0.02, 0.5, 0.97]) {
      let inside = 0;
      for (let round = 0; round < 2000; round++) {
        let successes = 0;
        for (let i = 0; i < 200; i++) if (random.unit() < p) successes++;
        const { low, high } = wilsonInterval(successes, 200);
        if (low <= p && p <= high) inside++;
      }
      expect(inside / 2000).toBeGreaterThan(0.93);
      expect(inside / 2000).toBeLessThan(0.98);
    }
  });

  it('ends at 0 and 1, and never has width 0', () => {
    expect(wilsonInterval(0, 100).low).toBe(0);
    expect(wilsonInterval(0, 100).high).toBeCloseTo(0.036995, 5);
    expect(wilsonInterval(100, 100).high).toBe(1);
    expect(wilsonInterval(0, 0)).toEqual({ low: 0, high: 1 });
  });
});

describe('shifted holds', () => {
  it('are what one button makes of them, tick by tick', () => {
    fc.assert(
      fc.property(
        arbitraryHolds(60),
        fc.array(fc.integer({ min: -70, max: 70 }), { minLength: 12, maxLength: 12 }),
        (holds, by) => {
          const shifted = shiftHolds(holds, by);
          const isHeld = (tick: number) =>
            holds.some(([press, release], i) => {
              const from = Math.max(0, press + by[2 * i]);
              return from <= tick && tick < Math.max(0, release + by[2 * i + 1]);
            });
          for (let tick = 0; tick <= 131; tick++) {
            expect(shifted.some(([press, release]) => press <= tick && tick < release)).toBe(isHeld(tick));
          }
          shifted.forEach(([press, release], i) => {
            expect(release).toBeGreaterThan(press);
            if (i > 0) expect(press).toBeGreaterThan(shifted[i - 1][1]);
          });
        },
      ),
    );
  });
});
