import { joinHolds, maxTicksOf, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { type Goal, type Success, successProbability } from '../../solver/index.ts';
import { drawShift, shiftHolds, tickNoise, uniformOf } from '../../solver/measure/robustness/index.ts';
import type { Share } from './attempt.ts';
import { type EdgeStatistics, edgeStatistics } from './edges.ts';
import { Stage } from './replay.ts';

/** The timing noise at which the model succeeds as often as the players. */
export interface ExplainingNoise {
  /** Standard deviation of the noise, ms. */
  readonly ms: number;
  /** Less noise than this does not explain the players' success, ms. */
  readonly low: number;
  /** Nor does more than this, ms. */
  readonly high: number;
  /** True if the model succeeds more often than the players even at the most noise that is tried; `ms` is then this noise. */
  readonly capped: boolean;
}

/** What the model expects between one press or release and the next. */
export interface EdgeExpectation {
  /** The share that fails there of the noisy attempts that come so far, 0 to 1. */
  readonly share: number;
  /** Lower end of its 95 % confidence interval. */
  readonly low: number;
  /** Upper end of it. */
  readonly high: number;
  /** Whether players fail there more or less often: the two intervals do not overlap. null: no difference is certain. */
  readonly players: 'more' | 'less' | null;
}

/** What timing noise explains of what players do. */
export interface ModelComparison {
  /** The noise that explains the players' success. */
  readonly noise: ExplainingNoise;
  /** What the model expects at that noise, for each entry of the players' edges. */
  readonly edges: readonly EdgeExpectation[];
}

/** Options of {@link compareWithModel}. */
export interface ComparisonOptions {
  /** Noisy attempts for each noise; 1000 by default. */
  readonly samples?: number;
  /** Seed of the noise; 0 by default. */
  readonly seed?: number;
  /** An attempt fails when it lasts longer than this, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** The noises that are tried, ms. Success between two of them is taken as linear. */
const SIGMAS = [0, 10, 20, 30, 40, 50, 60, 70, 80, 100, 120, 140, 160, 180, 200, 230, 260, 300, 350, 400, 450, 500] as const;

/**
 * Compares players with the model of timing noise: every press and release of a run is off by an independent Gaussian error.
 * @param scene the compiled level
 * @param holds the run that players are compared with
 * @param players how many attempts succeed, and after which press or release of the same run they fail
 * @param goal what an attempt has to achieve
 * @param options samples, seed and limit
 */
export function compareWithModel(
  scene: Scene,
  holds: readonly Hold[],
  players: Share & { readonly edges: readonly EdgeStatistics[] },
  goal: Goal,
  options: ComparisonOptions = {},
): ModelComparison {
  const { samples = 1000, seed = 0, maxTicks = maxTicksOf(scene.terms) } = options;
  const measure = (sigma: number): Success => {
    const success = successProbability(scene, holds, goal, sigma, { samples: sigma === 0 ? 1 : samples, seed, maxTicks });
    // without noise, one attempt is certain
    return sigma === 0 ? { ...success, low: success.p, high: success.p } : success;
  };
  const noise = explainingNoise(curveAround(measure, players), players);
  const run = joinHolds(holds);
  const stage = new Stage(scene, goal);
  const errors = tickNoise(noise.ms);
  const attempts = Array.from({ length: samples }, (_, sample) => {
    const shifts = run.flat().map((__, edge) => drawShift(errors, uniformOf(seed, sample, edge)));
    return stage.attempt(shiftHolds(run, shifts), maxTicks, 'timeout', sample);
  }).filter((attempt) => attempt !== null);
  const expected = edgeStatistics(run.flat(), attempts);
  return {
    noise,
    edges: expected.map(({ share, low, high }, i) => {
      const own = players.edges[i];
      return { share, low, high, players: own.low > high ? 'more' : own.high < low ? 'less' : null };
    }),
  };
}

/** Measures success at the noises between which it crosses the share of the players and the ends of its interval. */
function curveAround(measure: (sigma: number) => Success, players: Pick<Share, 'share' | 'low' | 'high'>): Success[] {
  const known = new Map<number, Success>();
  const at = (i: number): Success => {
    const success = known.get(i) ?? measure(SIGMAS[i]);
    known.set(i, success);
    return success;
  };
  const bracket = (figure: 'p' | 'low' | 'high', value: number): void => {
    let [above, below] = [0, SIGMAS.length - 1];
    if (at(above)[figure] < value || at(below)[figure] >= value) return;
    while (below - above > 1) {
      const middle = (above + below) >> 1;
      if (at(middle)[figure] >= value) above = middle;
      else below = middle;
    }
  };
  bracket('p', players.share);
  bracket('low', players.high);
  bracket('high', players.low);
  return [...known].sort(([a], [b]) => a - b).map(([, success]) => success);
}

/**
 * Inverts a curve of success over noise. Both ends of the interval take the uncertainty of the players' share and of the curve
 * into account.
 * @param curve success at ascending noises, the first of them 0
 * @param players the share of players' attempts that succeed
 */
export function explainingNoise(curve: readonly Success[], players: Pick<Share, 'share' | 'low' | 'high'>): ExplainingNoise {
  const sigmas = curve.map(({ sigma }) => sigma);
  const middle = decreasing(curve.map(({ p }) => p));
  return {
    ms: crossing(sigmas, middle, players.share),
    low: crossing(sigmas, decreasing(curve.map(({ low }) => low)), players.high),
    high: crossing(sigmas, decreasing(curve.map(({ high }) => high)), players.low),
    capped: middle[middle.length - 1] > players.share,
  };
}

/**
 * The sequence that never increases and is nearest to the given one by least squares: neighbours in the wrong order are pooled
 * (pool adjacent violators; M. Ayer and others, An empirical distribution function for sampling with incomplete information,
 * 1955).
 */
export function decreasing(values: readonly number[]): number[] {
  const pools: { sum: number; count: number }[] = [];
  for (const value of values) {
    let pool = { sum: value, count: 1 };
    for (let last = pools.at(-1); last !== undefined && last.sum / last.count < pool.sum / pool.count; last = pools.at(-1)) {
      pool = { sum: pool.sum + last.sum, count: pool.count + last.count };
      pools.pop();
    }
    pools.push(pool);
  }
  return pools.flatMap(({ sum, count }) => new Array<number>(count).fill(sum / count));
}

/** Where a sequence that never increases falls below a value: the last place, linear between the points. */
function crossing(at: readonly number[], values: readonly number[], value: number): number {
  const last = values.findLastIndex((own) => own >= value);
  if (last < 0) return at[0];
  if (last === at.length - 1) return at[last];
  const part = (values[last] - value) / (values[last] - values[last + 1]);
  return at[last] + part * (at[last + 1] - at[last]);
}
