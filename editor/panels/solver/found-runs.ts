import type { Scene } from '../../../engine/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../../solver/index.ts';
import type { Solving } from '../../workers/index.ts';

/** A run that was found, and whether it still does what it was found for. */
export interface Found {
  /** The same for the same holds. */
  readonly id: string;
  readonly candidate: Candidate;
  /** Chance of success with timing noise of 40 ms, 0 to 1; null where it was not measured. */
  readonly p40: number | null;
  readonly certified: boolean;
  /** False: the level has changed since, and in this one the run fails. */
  readonly works: boolean;
}

/** What a search has found so far, best first. */
export const foundBy = ({ solutions }: Solving): Found[] =>
  solutions.map((solution) => ({
    id: solution.holds.join(),
    candidate: solution,
    p40: solution.p40?.p ?? null,
    certified: solution.certified,
    works: true,
  }));

/** Runs that were found in another level, tried in this one. */
export const triedIn = (scene: Scene, goal: Goal, found: readonly Found[]): Found[] =>
  found.map((one) => {
    const verified = verifyRun(scene, one.candidate.holds, goal);
    // chances were those in the level as it was
    return { ...one, candidate: verified ?? one.candidate, works: verified !== null, p40: null, certified: false };
  });
