import type { Scene } from '../../../engine/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../../solver/index.ts';
import type { Solving } from '../../workers/index.ts';

/** A run that a search found, and whether it still meets the goal. */
export interface Found {
  /** equal for equal holds */
  readonly id: string;
  readonly candidate: Candidate;
  /** Success with timing noise of 40 ms, 0 to 1; null if not measured. */
  readonly p40: number | null;
  readonly certified: boolean;
  /** False if the level has changed and the run now fails. */
  readonly works: boolean;
}

/** The runs that a search has found so far, best first. */
export const foundBy = ({ solutions }: Solving): Found[] =>
  solutions.map((solution) => ({
    id: solution.holds.join(),
    candidate: solution,
    p40: solution.p40?.p ?? null,
    certified: solution.certified,
    works: true,
  }));

/** Checks runs that were found in another state of the level. */
export const triedIn = (scene: Scene, goal: Goal, found: readonly Found[]): Found[] =>
  found.map((one) => {
    const verified = verifyRun(scene, one.candidate.holds, goal);
    // the success was measured in the previous state of the level
    return { ...one, candidate: verified ?? one.candidate, works: verified !== null, p40: null, certified: false };
  });
