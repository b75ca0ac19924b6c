import { describe, expect, it } from 'vitest';
import { compile, type Scene } from '../../../engine/index.ts';
import { createSolver, type Goal, measureRobustness, type Solution, successProbability } from '../../../solver/index.ts';
import { pack } from '../../levels/shipped-pack.ts';

const goal: Goal = { minerals: 'any' };
const SAMPLES = 4000;

interface Found {
  readonly scene: Scene;
  readonly seed: number;
  readonly solution: Solution;
}

// So little effort that many runs are still mediocre: a perfect run cannot be flattered.
// Every run has a seed of its own, because runs that are measured by the same noise err together.
const found: Found[] = pack.flatMap(({ level }, i) => {
  const scene = compile(level, 'arcade');
  return [0, 1, 2].flatMap((n) => {
    const seed = 3 * i + n;
    const solver = createSolver(scene, { seed });
    while (!solver.finished && solver.effort.ticks < 400_000) solver.advance(50_000);
    return solver.best === null ? [] : [{ scene, seed, solution: solver.best }];
  });
});

/** Mean of estimate minus truth over runs that sometimes fail, and its standard error. */
function flattery(estimate: (one: Found) => number, samples: number): { mean: number; error: number; runs: number } {
  let [sum, variance, runs] = [0, 0, 0];
  for (const one of found) {
    const seed = 1_000_000 + one.seed;
    const p = successProbability(one.scene, one.solution.holds, goal, 40, { samples: SAMPLES, seed }).p;
    if (p < 0.02 || p > 0.98) continue;
    sum += estimate(one) - p;
    variance += p * (1 - p) * (1 / samples + 1 / SAMPLES);
    runs++;
  }
  return { mean: sum / runs, error: Math.sqrt(variance) / runs, runs };
}

describe('what a solver reports of the best of many runs', () => {
  it('is as often too low as too high', () => {
    const { mean, error, runs } = flattery(({ solution }) => solution.p40?.p ?? Number.NaN, 1000);
    expect(runs).toBeGreaterThan(15);
    expect(Math.abs(mean)).toBeLessThan(3.5 * error);
  });

  it('is what measureRobustness says with the same seed', () => {
    for (const { scene, seed, solution } of found.slice(0, 12)) {
      const { p40 } = measureRobustness(scene, solution.holds, goal, { seed, samples: 1000, maxRuns: 1 });
      expect(solution.p40).toEqual(p40);
    }
  });
});
