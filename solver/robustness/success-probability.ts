import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { finish, type Steps } from '../steps.ts';
import { judgeInSteps } from './script-tree.ts';
import { shiftHolds } from './shift-holds.ts';
import { drawShift, type TickNoise, tickNoise, uniformOf } from './tick-noise.ts';
import { createTrials, type Trials } from './trials.ts';
import { wilsonInterval } from './wilson.ts';

/** How often a run succeeds when every edge comes at a slightly wrong time. */
export interface Success {
  /** Standard deviation of each edge's time, ms. */
  readonly sigma: number;
  /** Share of the samples that met the goal. */
  readonly p: number;
  /** Wilson's 95 % interval for the probability. */
  readonly low: number;
  readonly high: number;
  readonly samples: number;
}

export interface SampleOptions {
  /** Executions tried; 1000 when left out. */
  readonly samples?: number;
  /** 0 when left out. */
  readonly seed?: number;
}

/** Executions tried when nothing else is said: p is then known within 3 %. */
export const DEFAULT_SAMPLES = 1000;

/**
 * The probability that a run meets the goal when every press and release is off by independent Gaussian noise, sampled.
 * The same seed lays the same noise on every run. Shifted edges are read as in `shiftHolds`.
 * @param sigma standard deviation, ms
 */
export const successProbability = (
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  sigma: number,
  options: SampleOptions = {},
): Success => finish(successInSteps(scene, holds, goal, sigma, options));

/** {@link successProbability}, some runs a step. */
export function* successInSteps(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  sigma: number,
  { samples = DEFAULT_SAMPLES, seed = 0 }: SampleOptions = {},
): Steps<Success> {
  const count = yield* countInSteps(createTrials(scene, goal), joinHolds(holds), tickNoise(sigma), seed, 0, samples);
  return toSuccess(sigma, count, samples);
}

/** A share of successes with its interval. */
export function toSuccess(sigma: number, successes: number, samples: number): Success {
  return { sigma, p: successes / samples, ...wilsonInterval(successes, samples), samples };
}

/** How many of the executions `from` up to, not including, `to` meet the goal. */
export const countSuccesses = (
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  seed: number,
  from: number,
  to: number,
): number => finish(countInSteps(trials, holds, noise, seed, from, to));

/** {@link countSuccesses}, some runs a step. */
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
