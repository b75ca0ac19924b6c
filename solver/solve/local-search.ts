import type { Hold } from '../../schema/index.ts';
import { normalBeyondHalf, type TickNoise, type Trials, tickNoise } from '../robustness/index.ts';
import { sampleNoise } from './noisy-sample.ts';

/** A local search from one run: its edges move to where noise does the least harm. */
export interface LocalSearch {
  /** Ticks, fractions included: press, release, press, ... */
  edges: number[];
  /** Where `edges` was when it last succeeded at all. */
  foothold: number[];
  /** Standard deviation of the noise it is tried with, ms: as much as it can stand. */
  sigma: number;
  /** How much it forgives, ms: as wide as a single window would be that fails as rarely. 0 before it is known. */
  width: number;
  /** Executions used up of the row of `seed`. */
  used: number;
  readonly seed: number;
}

/** Noise that a newly found run is first tried with, ms. */
const FIRST_SIGMA = 20;

/** Less noise than this hardly moves an edge by a tick, ms. */
const LEAST_SIGMA = 4;

/** How far the edges follow the drift: 1 never makes a run worse, more is faster. */
const STRIDE = 1.5;

export function createLocalSearch(holds: readonly Hold[], seed: number): LocalSearch {
  const edges = holds.flat();
  return { edges, foothold: edges, sigma: FIRST_SIGMA, width: 0, used: 0, seed };
}

/** The edges as holds: whole ticks, each hold one tick at least and one apart from the next. */
export function holdsOf(edges: readonly number[]): Hold[] {
  const holds: Hold[] = [];
  let free = 0;
  for (let i = 0; i < edges.length; i += 2) {
    const press = Math.max(free, Math.round(edges[i]));
    const release = Math.max(press + 1, Math.round(edges[i + 1]));
    holds.push([press, release]);
    free = release + 1;
  }
  return holds;
}

/**
 * One step up. With Gaussian noise the mean of the executions that succeed is a better centre than the one they were
 * drawn around (the mean-shift step: an EM step for the success probability, which it never lowers), for all edges at
 * once and at the price of one sample. Noise grows as the run can stand it.
 * @param samples executions tried
 * @param most the most noise it is tried with, ms
 */
export function meanShiftStep(trials: Trials, local: LocalSearch, samples: number, most: number): void {
  const { successes, tried, drift } = sampleNoise(
    trials,
    holdsOf(local.edges),
    noiseOf(local.sigma),
    local.seed,
    local.used,
    local.used + samples,
  );
  local.used += samples;
  if (successes === 0) {
    local.edges = [...local.foothold];
    local.sigma = Math.max(LEAST_SIGMA, local.sigma / 2);
    local.width = Math.min(local.width, local.sigma / 4);
    return;
  }
  const width = windowOf(successes / tried, local.sigma, tried);
  local.width = local.width === 0 ? width : (local.width + 2 * width) / 3;
  local.foothold = local.edges;
  local.edges = local.edges.map((tick, i) => tick + STRIDE * drift[i]);
  const share = successes / tried;
  if (share > 0.7) local.sigma = Math.min(most, local.sigma * 1.6);
  else if (share < 0.25) local.sigma = Math.max(LEAST_SIGMA, local.sigma / 1.5);
}

/** Edges after `steps` mean-shift steps under one kind of noise, each with executions of its own. */
export function shiftToMean(
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  { seed, from, samples, steps }: { seed: number; from: number; samples: number; steps: number },
): Hold[] {
  let edges = holds.flat();
  for (let step = 0; step < steps; step++) {
    const start = from + step * samples;
    const { drift, successes, tried } = sampleNoise(trials, holdsOf(edges), noise, seed, start, start + samples);
    if (successes === tried) break;
    edges = edges.map((tick, i) => tick + STRIDE * drift[i]);
  }
  return holdsOf(edges);
}

/** Half the width of a single window, ms, that an edge with this noise would hit so often. */
function windowOf(share: number, sigma: number, tried: number): number {
  // what a sample of this size can't tell from always or never
  const sure = 0.4 / tried;
  const p = Math.min(1 - sure, Math.max(sure, share));
  let low = 0;
  let high = 5;
  for (let i = 0; i < 30; i++) {
    const middle = (low + high) / 2;
    if (2 * normalBeyondHalf(middle) < p) low = middle;
    else high = middle;
  }
  return low * sigma;
}

const noiseOf = (sigma: number): TickNoise => tickNoise(Math.round(sigma));
