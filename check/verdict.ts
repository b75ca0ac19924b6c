import type { Verdict } from '../schema/index.ts';

/** The verdict on a level that could be read and checked. */
export type LevelVerdict = Exclude<Verdict, 'invalid' | 'crashed'>;

/** The facts on which a verdict rests. */
export interface Facts {
  /** Whether a run completes the level, either its own or one that a search found. */
  readonly isCompleted: boolean;
  /** Whether it is proved that nobody can complete the level. */
  readonly isImpossible: boolean;
  /** How many runs the level has. */
  readonly runs: number;
  /** Whether all of them were simulated to their end. */
  readonly areAllPlayed: boolean;
}

/**
 * Decides the verdict on a level. A completing run outweighs a proof. A run that was not simulated to its end may still
 * complete the level, so such a level is `unproven` and not `broken`.
 * @param facts what is known of the level
 * @returns the verdict
 */
export function verdictOf({ isCompleted, isImpossible, runs, areAllPlayed }: Facts): LevelVerdict {
  if (isCompleted) return 'completable';
  if (isImpossible) return 'impossible';
  return runs > 0 && areAllPlayed ? 'broken' : 'unproven';
}

/**
 * Updates a verdict that was given before proofs were sought.
 * @param verdict the verdict without proofs
 * @param isImpossible whether it is proved that nobody can complete the level
 * @returns the final verdict
 */
export const onceProved = (verdict: LevelVerdict, isImpossible: boolean): LevelVerdict =>
  isImpossible && verdict !== 'completable' ? 'impossible' : verdict;
