import type { Hold } from '../../../schema/basics/index.ts';
import {
  countSuccesses,
  FIRST_TO_CHOOSE_BY,
  judgeAll,
  mirroredShift,
  normalBeyondHalf,
  shiftHolds,
  type TickNoise,
  type Trials,
  tickNoise,
} from '../../measure/robustness/index.ts';
import type { Random } from '../../random.ts';
import type { SolverSession } from './solver-session.ts';

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
export function wholeTicks(edges: readonly number[]): Hold[] {
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
    wholeTicks(local.edges),
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
    const { drift, successes, tried } = sampleNoise(trials, wholeTicks(edges), noise, seed, start, start + samples);
    if (successes === tried) break;
    edges = edges.map((tick, i) => tick + STRIDE * drift[i]);
  }
  return wholeTicks(edges);
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

/**
 * Makes a random variation of a run: drops a hold, shifts everything from one edge on, inserts a pause or a hold, cuts off the
 * end, or shakes all edges.
 */
export function changeRun(holds: readonly Hold[], random: Random): Hold[] {
  const edges = holds.flat();
  const between = (low: number, high: number) => low + random.below(Math.max(1, high - low));
  switch (random.below(5)) {
    case 0:
      if (edges.length > 2) edges.splice(2 * random.below(holds.length), 2);
      break;
    case 1: {
      const first = random.below(edges.length);
      const by = (random.below(2) === 0 ? 1 : -1) * between(4, 44);
      for (let i = first; i < edges.length; i++) edges[i] += by;
      break;
    }
    case 2: {
      // Insert two edges into a stretch: a pause into a hold, or a hold into a pause.
      const place = random.below(edges.length);
      const low = place === 0 ? 0 : edges[place - 1];
      if (edges[place] - low <= 20) break;
      const first = between(low + 4, edges[place] - 12);
      edges.splice(place, 0, first, between(first + 4, Math.min(first + 64, edges[place] - 2)));
      break;
    }
    case 3: {
      // Drop everything after one of the holds, and make that hold longer.
      const last = random.below(holds.length);
      edges.length = 2 * last + 2;
      edges[2 * last + 1] += 240;
      break;
    }
    default: {
      const size = between(10, 40);
      for (let i = 0; i < edges.length; i++) edges[i] += Math.round((random.unit() + random.unit() - 1) * size);
    }
  }
  return inOrder(edges);
}

/** Restores the order of edges by moving those that come too early. */
function inOrder(edges: readonly number[]): Hold[] {
  const holds: Hold[] = [];
  let last = -1;
  for (let i = 0; i < edges.length; i += 2) {
    const press = Math.max(last + 1, edges[i]);
    last = Math.max(press + 1, edges[i + 1]);
    holds.push([press, last]);
  }
  return holds;
}

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
