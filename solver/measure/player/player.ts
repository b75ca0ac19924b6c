import { TICK_RATE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { playFrom, shiftHolds, type Trials, uniformOf } from '../robustness/index.ts';
import { exponential, logarithm, normalQuantile } from './elementary.ts';
import type { PlayerParameters } from './parameters.ts';

/** What came of one attempt. */
export interface PlayedAttempt {
  /** The holds that the player made, as the game reads them. */
  readonly holds: readonly Hold[];
  /** Whether it met the goal. */
  readonly succeeds: boolean;
  /** The tick at which it ended. */
  readonly end: number;
}

/** A number in (0, 1) that depends only on its three indices. */
export const uniformIn01 = (seed: number, sample: number, index: number): number =>
  (uniformOf(seed, sample, index) + 0.5) / 4294967296;

/**
 * One synthetic player, who aims at a run, misses by as much as skill and practice make likely, and learns from attempt to attempt.
 * Errors depend only on the seed and on the numbers of player, attempt and edge, so that runs and levels are compared under the same
 * luck.
 */
export class Player {
  private readonly practice: Int32Array;
  private readonly shifts: Int32Array;
  private attempts = 0;

  /**
   * @param start a snapshot of the start of the level
   * @param holds the run to aim at; sorted and disjoint
   * @param left see `practiceTable`
   * @param factor the player's own factor: 1 is the median of the literature, less is a better player
   */
  constructor(
    private readonly trials: Trials,
    private readonly start: Float64Array,
    private readonly holds: readonly Hold[],
    private readonly run: TimedRun,
    private readonly left: Float64Array,
    private readonly factor: number,
    private readonly seed: number,
  ) {
    this.practice = new Int32Array(run.edges.length);
    this.shifts = new Int32Array(run.edges.length);
  }

  /** Plays the next attempt. */
  attempt(): PlayedAttempt {
    const { run, practice, shifts, trials, holds } = this;
    let error = 0;
    for (let edge = 0; edge < shifts.length; edge++) {
      const own = normalQuantile(uniformIn01(this.seed, this.attempts, edge));
      const left = this.left[Math.min(practice[edge], this.left.length - 1)];
      error = (run.inherits[edge] === 1 ? error : 0) + own * deviationOf(run, edge, left, this.factor);
      shifts[edge] = Math.round((error * TICK_RATE) / 1000);
    }
    this.attempts++;
    const played = shiftHolds(holds, shifts);
    const succeeds = playFrom(trials, this.start, played);
    const { ending, tick } = trials.simulation;
    const end = ending?.tick ?? tick;
    let reached = 0;
    while (reached < shifts.length && run.edges[reached] + shifts[reached] < end) reached++;
    practise(practice, reached, !succeeds);
    return { holds: played, succeeds, end };
  }
}

const MS_PER_TICK = 1000 / TICK_RATE;

/** What a player has to time in a run: its presses and releases, and how uncertain each is. */
export interface TimedRun {
  /** When the run changes the button, ticks: press, release, press, ... */
  readonly edges: readonly number[];
  /** Variance of the motor noise of each edge, ms^2, for a factor of 1. */
  readonly motor: number;
  /** Variance of what can be learned of each edge, ms^2, for a factor of 1 and without practice. */
  readonly learnable: Float64Array;
  /** 1 where an edge inherits the error of the one before it, because there is no time to react; else 0. */
  readonly inherits: Uint8Array;
}

/**
 * Works out what a player has to time. The interval to the edge before says how long time has to be kept; the time until the edge
 * after it, or until the end, says how far its consequences have to be foreseen.
 * @param edges when the run changes the button, ticks, ascending
 * @param end when the run ends, ticks
 */
export function timeRun(edges: readonly number[], end: number, parameters: PlayerParameters): TimedRun {
  const { motorMs, weber, reactionMs, lookaheadMs, planMs } = parameters;
  const learnable = new Float64Array(edges.length);
  const inherits = new Uint8Array(edges.length);
  for (const [i, tick] of edges.entries()) {
    const since = MS_PER_TICK * (tick - (i === 0 ? 0 : edges[i - 1]));
    const until = MS_PER_TICK * Math.max(0, (edges[i + 1] ?? Math.max(end, tick)) - tick);
    const kept = weber * Math.min(since, lookaheadMs);
    const guessed = (planMs * until) / (until + lookaheadMs);
    learnable[i] = kept * kept + guessed * guessed;
    if (i > 0 && since < reactionMs) inherits[i] = 1;
  }
  return { edges, motor: motorMs * motorMs, learnable, inherits };
}

/** The share of the variance that is left after n = 0, 1, 2, ... times of practice: (1 + n)^(-2 exponent). */
export function practiceTable(learning: number, most: number): Float64Array {
  return Float64Array.from({ length: most + 1 }, (_, n) => exponential(-2 * learning * logarithm(1 + n)));
}

/** The standard deviation of an edge's own error, ms. @param left see {@link practiceTable} */
export const deviationOf = (run: TimedRun, edge: number, left: number, factor: number): number =>
  factor * Math.sqrt(run.motor + run.learnable[edge] * left);

/**
 * How much a player misses by: the root of the mean of all edges' variances, ms.
 * @param left see {@link practiceTable}
 */
export function typicalError(run: TimedRun, left: number, factor: number): number {
  const deviations = run.edges.map((_, edge) => deviationOf(run, edge, left, factor));
  return Math.sqrt(deviations.reduce((sum, own) => sum + own * own, 0) / Math.max(1, deviations.length));
}

/**
 * Counts an attempt as practice: each edge that was made once, and both edges of the hold after which it failed once more.
 * @param practice how often each edge was practised; changed
 * @param reached how many edges were made
 * @param failed whether the attempt failed
 */
export function practise(practice: Int32Array, reached: number, failed: boolean): void {
  for (let i = 0; i < reached; i++) practice[i]++;
  if (!failed || reached === 0) return;
  const last = reached - 1;
  for (let i = last - (last % 2); i <= last; i++) practice[i]++;
}
