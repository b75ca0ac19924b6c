import type { Hold } from '../../../schema/basics/index.ts';
import type { Solution } from './solution.ts';

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
