import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import { createSolverSession } from '../../solver/search/solve/solver-session.ts';
import { plainLevel } from '../engine/plain-level.ts';

const scene = compile(plainLevel());
const goal = { minerals: 'any' } as const;

function seedOf(seed: number, lane: number): (n: number) => number {
  const session = createSolverSession(scene, { goal, seed, lane, maxTicks: 3600, objective: 'robust', count: 1, known: [] });
  return session.seedOf;
}

/** As a whole number of any size. */
const exactly = (seed: number, lane: number, n: number): bigint =>
  (BigInt(seed) * 1_000_000_000n + BigInt(lane) * 1_000_000n + BigInt(n)) % 2n ** 53n;

// Beyond 9,007,199 the plain sum is rounded to multiples of up to 512, which made all searches of a lane the same.
describe('each piece of work of a solver has its own seed', () => {
  const seed = fc.oneof(fc.nat(10_000_000), fc.integer({ min: 0, max: 2 ** 32 - 1 }), fc.maxSafeNat());

  it('to the last bit, however large the seed', () => {
    fc.assert(
      fc.property(seed, fc.nat(999), fc.nat(999_999), (s, lane, n) => {
        expect(BigInt(seedOf(s, lane)(n))).toBe(exactly(s, lane, n));
      }),
    );
  });

  it('also in the lane of the largest seed of gq solve', () => {
    const own = seedOf(2 ** 32 - 1, 3);
    expect(new Set(Array.from({ length: 1000 }, (_, n) => own(n))).size).toBe(1000);
  });
});
