import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import type { Goal } from '../../verified-run.ts';
import { drawShift, type TickNoise, tickNoise, uniformOf } from './tick-noise.ts';
import { createTrials, judgeInSteps, shiftHolds, type Trials } from './trials.ts';

/** How often a run succeeds under timing noise. */
export interface Success {
  /** Standard deviation of each edge's time, ms. */
  readonly sigma: number;
  /** Success: the share of the samples that met the goal, 0 to 1. */
  readonly p: number;
  /** Lower end of the 95 % confidence interval of the probability (Wilson's score interval), 0 to 1. */
  readonly low: number;
  /** Upper end of the 95 % confidence interval, 0 to 1. */
  readonly high: number;
  /** How many attempts were simulated. */
  readonly samples: number;
}

/** How timing noise is sampled. */
export interface SampleOptions {
  /** Attempts to simulate; 1000 by default. */
  readonly samples?: number;
  /** Seed of the noise, any whole number; 0 by default. */
  readonly seed?: number;
  /** An attempt fails when it lasts longer than this, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** Attempts simulated by default: the probability is then known to within 3 %. */
export const DEFAULT_SAMPLES = 1000;

/**
 * Estimates how often a run meets the goal when every press and release is off by independent Gaussian timing noise. The same
 * seed puts the same noise on every run, so that runs can be compared. Shifted edges are read as in `shiftHolds`.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param sigma standard deviation of the noise, ms
 * @param options how many samples, their seed, and the limit of an attempt
 * @returns the share of successes and its confidence interval
 */
export const successProbability = (
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  sigma: number,
  options: SampleOptions = {},
): Success => finish(successInSteps(scene, holds, goal, sigma, options));

/**
 * {@link successProbability} in steps of a few runs.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param sigma standard deviation of the noise, ms
 * @param options how many samples, their seed, and the limit of an attempt
 * @returns a generator that yields between steps and returns the share of successes with its confidence interval
 */
export function* successInSteps(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  sigma: number,
  { samples = DEFAULT_SAMPLES, seed = 0, maxTicks }: SampleOptions = {},
): Steps<Success> {
  const count = yield* countInSteps(createTrials(scene, goal, maxTicks), joinHolds(holds), tickNoise(sigma), seed, 0, samples);
  return toSuccess(sigma, count, samples);
}

/** Converts a number of successes into a share with its confidence interval. */
export function toSuccess(sigma: number, successes: number, samples: number): Success {
  return { sigma, p: successes / samples, ...wilsonInterval(successes, samples), samples };
}

/** Counts the successes among the attempts `from` (inclusive) to `to` (exclusive). */
export const countSuccesses = (
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  seed: number,
  from: number,
  to: number,
): number => finish(countInSteps(trials, holds, noise, seed, from, to));

/** {@link countSuccesses}, a few runs per step. */
export function* countInSteps(
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  seed: number,
  from: number,
  to: number,
): Steps<number> {
  const edges = 2 * holds.length;
  const shifts = new Int32Array(edges);
  const runs: Hold[][] = [];
  for (let sample = from; sample < to; sample++) {
    for (let edge = 0; edge < edges; edge++) shifts[edge] = drawShift(noise, uniformOf(seed, sample, edge));
    runs.push(shiftHolds(holds, shifts));
  }
  let count = 0;
  for (const success of yield* judgeInSteps(trials, runs)) count += success;
  return count;
}

/** The two-sided 95 % quantile of the normal distribution. */
const Z_95 = 1.959963984540054;

/** The two-sided 90 % quantile of the normal distribution. */
export const Z_90 = 1.6448536269514722;

/**
 * Wilson's score interval for a share of successes, at 95 % by default. Unlike the normal approximation it has a sensible width near 0 and
 * 1 (E. B. Wilson, Probable inference, the law of succession, and statistical inference, 1927).
 * @param z the two-sided quantile of the normal distribution that belongs to the level of confidence
 */
export function wilsonInterval(successes: number, samples: number, z = Z_95): { low: number; high: number } {
  if (samples === 0) return { low: 0, high: 1 };
  const p = successes / samples;
  const z2 = (z * z) / samples;
  const middle = p + z2 / 2;
  const half = z * Math.sqrt((p * (1 - p)) / samples + z2 / (4 * samples));
  const low = successes === 0 ? 0 : (middle - half) / (1 + z2);
  const high = successes === samples ? 1 : (middle + half) / (1 + z2);
  return { low: Math.max(0, low), high: Math.min(1, high) };
}
