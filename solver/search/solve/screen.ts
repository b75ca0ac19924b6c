import type { Hold } from '../../../schema/basics/index.ts';
import { countSuccesses, FIRST_TO_CHOOSE_BY, tickNoise } from '../../measure/robustness/index.ts';
import { shiftToMean } from './local-search.ts';
import type { SolverSession } from './solver-session.ts';

/** Attempts of each run in the first stage; each later stage doubles the total of the runs that are left. */
const FIRST_STAGE = 16;
const SEED = 3;

/** Attempts per mean-shift step of the runs that are left, and steps. */
const SAMPLES = 48;
const STEPS = 3;

/**
 * Picks the most robust of many runs by sequential halving (Z. Karnin, T. Koren, O. Somekh, Almost optimal exploration in
 * multi-armed bandits, 2013): all runs get the same noise, the better half goes on with twice as many attempts. The edges of
 * those that are left are moved to where noise does less harm. Yields between small pieces of work.
 * @param runs the runs, the most promising first; the order decides ties
 * @param sigma standard deviation of the noise, ms
 * @param finalists how many runs to return at most
 * @param seed the seed of the noise by which edges are moved
 */
export function* screen(
  { trials }: SolverSession,
  runs: readonly (readonly Hold[])[],
  { sigma, finalists, seed }: { sigma: number; finalists: number; seed: number },
): Generator<void, Hold[][]> {
  const noise = tickNoise(sigma);
  let left = runs.map((holds) => ({ holds, successes: 0 }));
  for (let from = 0, to = FIRST_STAGE; left.length > finalists; from = to, to *= 2) {
    for (const run of left) {
      run.successes += countSuccesses(trials, run.holds, noise, SEED, FIRST_TO_CHOOSE_BY + from, FIRST_TO_CHOOSE_BY + to);
      yield;
    }
    left.sort((a, b) => b.successes - a.successes);
    left = left.slice(0, Math.max(finalists, Math.ceil(left.length / 2)));
  }
  const moved: Hold[][] = [];
  for (const { holds } of left) {
    moved.push(shiftToMean(trials, holds, noise, { seed, from: 0, samples: SAMPLES, steps: STEPS }));
    yield;
  }
  return moved;
}
