import { TICK_RATE } from '../../../../engine/index.ts';
import type { Hold } from '../../../../schema/basics/index.ts';
import { playFrom, shiftHolds, type Trials, uniformOf } from '../../robustness/index.ts';
import { normalQuantile } from './normal-quantile.ts';
import { deviationOf, practise, type TimedRun } from './timing.ts';

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
