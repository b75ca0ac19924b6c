import type { Success } from '../robustness/index.ts';
import type { Candidate } from '../verified-run.ts';

/** What a good run is: one that forgives bad timing, few presses, a short time, or any at all. */
export type Objective = 'robust' | 'presses' | 'time' | 'first';

/**
 * A run that meets its goal, with what it is worth. Under `robust` a hold that lasts to the end goes on for a while after
 * it, as a player would hold on: an execution that is a little late must not be let go too early.
 */
export interface Solution extends Candidate {
  /** Larger is better; only solutions of the same objective compare. */
  readonly score: number;
  /**
   * Success when every edge is off by 40 ms; null where the objective doesn't ask. Of many runs measured the best is kept,
   * so it flatters a little: `successProbability` with a seed of one's own is a fresh measurement.
   */
  readonly p40: Success | null;
  /** True when ALL shifts of every edge by up to two ticks were tried and succeed; false when not, or not tried. */
  readonly certified: boolean;
}

/** What a certificate is worth beside success under noise: as much as two executions in a hundred. */
const CERTIFICATE_WORTH = 0.02;

/** The score of a run under `robust`. */
export const robustScore = (p40: number, certified: boolean): number => p40 + (certified ? CERTIFICATE_WORTH : 0);
