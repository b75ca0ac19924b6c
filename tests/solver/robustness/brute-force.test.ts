import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, joinHolds, simulate } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { certify, findSlack, measureRobustness, successProbability } from '../../../solver/index.ts';
import { createTrials, drawShift, judgeAll, shiftHolds, tickNoise, uniformOf } from '../../../solver/measure/robustness/index.ts';
import { expectDeep } from '../../depth.ts';
import { fallThrough } from '../search/solvable-levels.ts';
import { ANY, arbitraryRun, type Found, succeeds } from './scenes.ts';

/** Every combination of one of `choices` for each of `n` edges. */
function* combinations(n: number, choices: readonly number[]): Generator<number[]> {
  if (n === 0) {
    yield [];
    return;
  }
  for (const rest of combinations(n - 1, choices)) for (const choice of choices) yield [...rest, choice];
}

const upTo = (k: number): number[] => Array.from({ length: 2 * k + 1 }, (_, i) => i - k);

/** The exact probability, by trying every pair of shifts of a single hold. */
function exactly(found: Found, sigma: number): number {
  const { probability, reach } = tickNoise(sigma);
  let p = 0;
  for (const shifts of combinations(2, upTo(reach))) {
    const weight = probability[shifts[0] + reach] * probability[shifts[1] + reach];
    if (weight > 1e-6 && succeeds(found, shiftHolds(found.holds, shifts))) p += weight;
  }
  return p;
}

/** The same for two runs that play alike, whatever they would do after the end. */
const played = ({ scene }: Found, holds: readonly Hold[]): string => simulate(scene, holds).hash;

describe.each(['arcade', 'precise'] as const)('at %s', (accuracy) => {
  const runs = 6;

  it('slack equals what trying every shift gives', () => {
    fc.assert(
      fc.property(arbitraryRun(accuracy), (found) => {
        const limit = 10;
        const slack = findSlack(found.scene, found.holds, found.goal, limit);
        const holds = joinHolds(found.holds);
        const byHand = (edge: number, direction: number) => {
          const shifts = new Array<number>(2 * holds.length).fill(0);
          for (let by = 0; by <= limit; by++) {
            shifts[edge] = by * direction;
            if (!succeeds(found, shiftHolds(holds, shifts))) return Math.max(0, by - 1);
          }
          return limit;
        };
        expect(slack).toEqual(
          holds.flatMap((_, i) => [2 * i, 2 * i + 1]).map((e) => ({ earlier: byHand(e, -1), later: byHand(e, 1) })),
        );
      }),
      { numRuns: runs },
    );
  });

  it('a certificate equals what trying every combination gives, also where edges change places', () => {
    let [proved, close] = [0, 0];
    fc.assert(
      fc.property(arbitraryRun(accuracy), (found) => {
        const limit = accuracy === 'arcade' ? 2 : 1;
        const holds = joinHolds(found.holds);
        const { ticks, exhausted, counterexample } = certify(found.scene, holds, found.goal, { limit, maxRuns: 1e6 });
        const all = (k: number) => [...combinations(2 * holds.length, upTo(k))].map((shifts) => shiftHolds(holds, shifts));
        const isSure = (k: number) => all(k).every((moved) => succeeds(found, moved));
        let largest = 0;
        while (largest < limit && isSure(largest + 1)) largest++;
        if (holds.length === 2 && holds[1][0] - holds[0][1] < 2 * limit) close++;
        proved += largest;
        expect(exhausted).toBe(false);
        expect(ticks).toBe(largest);
        if (largest === limit) expect(counterexample).toBeNull();
        else {
          expect(succeeds(found, counterexample ?? [])).toBe(false);
          // And it is one of the combinations, as far as it was simulated.
          if (succeeds(found, holds)) {
            const refuted = played(found, counterexample ?? []);
            expect(all(largest + 1).some((moved) => played(found, moved) === refuted)).toBe(true);
          }
        }
      }),
      // A certificate that tries extreme shifts only passes here: any-game.test.ts finds it.
      { numRuns: accuracy === 'arcade' ? 6 : 8 },
    );
    expectDeep(proved).toBeGreaterThan(0);
    expectDeep(close).toBeGreaterThan(0);
  });

  it('success under noise equals what simulating each attempt alone gives', () => {
    fc.assert(
      fc.property(arbitraryRun(accuracy, 3), fc.constantFrom(20, 40, 80), fc.nat(100), (found, sigma, seed) => {
        const samples = 60;
        const holds = joinHolds(found.holds);
        const noise = tickNoise(sigma);
        let successes = 0;
        for (let sample = 0; sample < samples; sample++) {
          const shifts = holds.flatMap((_, i) => [0, 1].map((end) => drawShift(noise, uniformOf(seed, sample, 2 * i + end))));
          if (succeeds(found, shiftHolds(holds, shifts))) successes++;
        }
        const success = successProbability(found.scene, found.holds, found.goal, sigma, { samples, seed });
        expect(success).toMatchObject({ sigma, samples, p: successes / samples });
        expect(success.low).toBeLessThanOrEqual(success.p);
        expect(success.high).toBeGreaterThanOrEqual(success.p);
      }),
      { numRuns: runs },
    );
  });
});

it('a sampled probability is near the exact one', () => {
  let between = 0;
  fc.assert(
    fc.property(arbitraryRun('arcade', 1), (found) => {
      const p = exactly(found, 30);
      if (p > 0.05 && p < 0.95) between++;
      const success = successProbability(found.scene, found.holds, found.goal, 30, { samples: 2000, seed: 5 });
      // Four and a half standard deviations.
      expect(Math.abs(success.p - p)).toBeLessThan(4.5 * Math.sqrt((p * (1 - p)) / 2000) + 1e-3);
    }),
    // Some of these succeed now and then.
    { numRuns: 8 },
  );
  expectDeep(between).toBeGreaterThan(0);
});

it('runs judged together are judged like each one alone, and share what they have in common', () => {
  fc.assert(
    fc.property(arbitraryRun('arcade', 2), fc.nat(50), (found, seed) => {
      const holds = joinHolds(found.holds);
      const noise = tickNoise(40);
      const runs = Array.from({ length: 40 }, (_, sample) =>
        shiftHolds(
          holds,
          Array.from({ length: 2 * holds.length }, (_, edge) => drawShift(noise, uniformOf(seed, sample, edge))),
        ),
      );
      // The same run twice, one that is the beginning of another, and an empty one.
      runs.push(runs[3], runs[5].slice(0, 1), []);
      const together = createTrials(found.scene, found.goal);
      expect([...judgeAll(together, runs)]).toEqual(runs.map((run) => (succeeds(found, run) ? 1 : 0)));
      const apart = createTrials(found.scene, found.goal);
      for (const run of runs) judgeAll(apart, [run]);
      expect(together.ticks).toBeLessThan(apart.ticks);
    }),
    { numRuns: 8 },
  );
});

describe('a run that fails', () => {
  const scene = compile(fallThrough(), 'arcade');
  const nothing: Hold[] = [];

  it('has no slack, no certificate and no success', () => {
    expect(findSlack(scene, [[0, 1]], { minerals: 'all' })).toEqual([
      { earlier: 0, later: 0 },
      { earlier: 0, later: 0 },
    ]);
    expect(certify(scene, nothing, ANY)).toEqual({ ticks: 0, exhausted: false, runs: 1, counterexample: [] });
    expect(successProbability(scene, nothing, ANY, 40, { samples: 10 }).p).toBe(0);
  });
});

it('reports when a certificate is too expensive', () => {
  const scene = compile(fallThrough(), 'arcade');
  const { ticks, exhausted, runs } = certify(scene, [[0, 600]], ANY, { maxRuns: 10 });
  expect(exhausted).toBe(true);
  expect(ticks).toBeGreaterThanOrEqual(0);
  expect(runs).toBeLessThanOrEqual(10);
  const measured = (maxRuns?: number) => measureRobustness(scene, [[0, 600]], ANY, { samples: 10, maxRuns });
  expect(measured(10)).toMatchObject({ certifiedTicks: ticks, decided: false });
  expect(measured().decided).toBe(true);
});

it('more noise is never much better, in a run that is in the middle of its window', () => {
  const scene = compile(fallThrough(), 'arcade');
  const { p30, p40, p60, p80, slack } = measureRobustness(scene, [[10, 600]], ANY, { samples: 300, maxRuns: 10 });
  expect(slack).toHaveLength(2);
  const shares = [p30, p40, p60, p80].map(({ p }) => p);
  for (let i = 1; i < shares.length; i++) expect(shares[i]).toBeLessThanOrEqual(shares[i - 1] + 0.05);
});
