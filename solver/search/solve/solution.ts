import type { Success } from '../../measure/robustness/index.ts';
import type { Candidate } from '../../verified-run.ts';

/**
 * What makes a run good: `robust` prefers success under timing noise, `presses` few presses, `time` a short run, and `first`
 * takes any run.
 */
export type Objective = 'robust' | 'presses' | 'time' | 'first';

/**
 * A run that meets its goal, with its score. Under `robust`, a hold that lasts to the end is extended a little beyond it, as a
 * player would hold on: otherwise a slightly late attempt would release too early.
 */
export interface Solution extends Candidate {
  /**
   * Larger is better. Only scores of the same objective can be compared. Under `robust` all runs are compared under the same
   * noise, and the best of them has often been lucky: `p40` says what a run is worth.
   */
  readonly score: number;
  /**
   * Success under timing noise of 40 ms; null for other objectives than `robust`. It was measured after the run had been chosen,
   * by attempts that had no part in the choice, so it is as often too low as too high. {@link measureRobustness} with the
   * solver's seed and 1000 samples gives the same.
   */
  readonly p40: Success | null;
  /**
   * True when ALL shifts of every edge by up to two ticks were tried and succeed; false when some fail or not all were tried.
   */
  readonly certified: boolean;
}

/** What a certificate adds to the score: as much as a success that is higher by 0.02. */
const CERTIFICATE_WORTH = 0.02;

/**
 * The score of a run under `robust`.
 * @param p success under timing noise of 40 ms, by the attempts that runs are compared by
 */
export const robustScore = (p: number, certified: boolean): number => p + (certified ? CERTIFICATE_WORTH : 0);
