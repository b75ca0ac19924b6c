import type { Hold } from '../../../schema/basics/index.ts';
import {
  judgeAll,
  mirroredShift,
  normalBeyondHalf,
  shiftHolds,
  type TickNoise,
  type Trials,
  tickNoise,
} from '../../measure/robustness/index.ts';

/** A local search that starts from one run and moves its edges to where timing noise does the least harm. */
export interface LocalSearch {
  /** Ticks with fractions: press, release, press, ... */
  edges: number[];
  /** The last `edges` with any success. */
  foothold: number[];
  /** Standard deviation of the noise, ms: as much as the run can stand. */
  sigma: number;
  /** How robust the run is: the half width of a single window that fails as rarely, ms; 0 before it is measured. */
  width: number;
  /** How many attempts of the sequence of `seed` have been used. */
  used: number;
  /** Seed of the noise. */
  readonly seed: number;
}

/** Noise for a run that was just found, ms. */
const FIRST_SIGMA = 20;

/** The least noise, ms; less of it hardly moves an edge by a tick. */
const LEAST_SIGMA = 4;

/** How far the edges follow the measured drift. A factor of 1 never makes a run worse, a larger one is faster. */
const STRIDE = 1.5;

/** Starts a local search at a run. */
export function createLocalSearch(holds: readonly Hold[], seed: number): LocalSearch {
  const edges = holds.flat();
  return { edges, foothold: edges, sigma: FIRST_SIGMA, width: 0, used: 0, seed };
}

/** Rounds edges to whole ticks, and keeps holds at least one tick long and one tick apart. */
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
 * Takes one mean-shift step: it moves all edges to their mean over the attempts that succeed. Under Gaussian noise this is an
 * EM step for the probability of success, which it never lowers, and one sample serves all edges at once. The noise grows as
 * far as the run can stand it.
 * @param samples attempts to simulate
 * @param most the most noise to use, ms
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

/** Takes `steps` mean-shift steps under fixed noise, each with new attempts. */
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

/** The half width of a single window that an edge with this noise would hit with this share, ms. */
function windowOf(share: number, sigma: number, tried: number): number {
  // A sample of this size cannot tell these shares from never and always.
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

/** What timing noise did to a run. */
interface NoisySample {
  /** Attempts that met the goal. */
  readonly successes: number;
  /** Attempts simulated. */
  readonly tried: number;
  /**
   * The mean shift of each edge over the successful attempts, ticks; it points to where there is more room. All 0 without a
   * success.
   */
  readonly drift: Float64Array;
}

/**
 * Simulates a run under timing noise, with attempts to choose by.
 * @param from the first attempt of the seed's endless sequence
 * @param to one past the last attempt
 */
function sampleNoise(
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  seed: number,
  from: number,
  to: number,
): NoisySample {
  const edges = 2 * holds.length;
  const shifts: Int32Array[] = [];
  for (let i = from; i < to; i++) {
    const shift = new Int32Array(edges);
    for (let edge = 0; edge < edges; edge++) shift[edge] = mirroredShift(noise, seed, i, edge);
    shifts.push(shift);
  }
  const succeeded = judgeAll(
    trials,
    shifts.map((shift) => shiftHolds(holds, shift)),
  );
  const drift = new Float64Array(edges);
  let successes = 0;
  for (let i = 0; i < shifts.length; i++) {
    if (succeeded[i] === 0) continue;
    successes++;
    for (let edge = 0; edge < edges; edge++) drift[edge] += shifts[i][edge];
  }
  if (successes > 0) for (let edge = 0; edge < edges; edge++) drift[edge] /= successes;
  return { successes, tried: shifts.length, drift };
}
