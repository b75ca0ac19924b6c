import type { Hold } from '../../../schema/basics/index.ts';
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

/** Two runs count as the same way through a level if they have as many holds and no edge differs by more than this, ticks. */
const SAME_WAY = 30;

/**
 * Merges lists of solutions of the same objective. The order of the lists does not matter, because ties are broken by the runs
 * themselves.
 * @param lists the solutions of each solver
 * @param options how many solutions to keep
 * @returns the best solutions, best first; runs that are nearly the same as a better one are left out
 */
export function mergeSolutions(
  lists: readonly (readonly Solution[])[],
  {
    count = 1,
  }: {
    /** The most solutions to return; 1 by default. */
    readonly count?: number;
  } = {},
): Solution[] {
  const merged: Solution[] = [];
  for (const solution of lists.flat().sort(compareSolutions)) {
    if (merged.length >= count) break;
    if (!merged.some((kept) => isSameWay(kept.holds, solution.holds))) merged.push(solution);
  }
  return merged;
}

/** Orders solutions, the better first: by score, number of presses, time, and finally the holds themselves. */
export function compareSolutions(a: Solution, b: Solution): number {
  if (a.score !== b.score) return b.score - a.score;
  if (a.holds.length !== b.holds.length) return a.holds.length - b.holds.length;
  if (a.time !== b.time) return a.time - b.time;
  for (let i = 0; i < a.holds.length; i++) {
    for (let end = 0; end < 2; end++) {
      if (a.holds[i][end] !== b.holds[i][end]) return a.holds[i][end] - b.holds[i][end];
    }
  }
  return 0;
}

/** Whether two runs have as many holds at about the same times. */
export function isSameWay(a: readonly Hold[], b: readonly Hold[]): boolean {
  if (a.length !== b.length) return false;
  return a.every(([press, release], i) => near(press, b[i][0]) && (i === a.length - 1 || near(release, b[i][1])));
}

const near = (a: number, b: number): boolean => Math.abs(a - b) <= SAME_WAY;
