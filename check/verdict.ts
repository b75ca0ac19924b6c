import type { Verdict } from '../schema/index.ts';

/** What can be said of a level that could be read and checked. */
export type LevelVerdict = Exclude<Verdict, 'invalid' | 'crashed'>;

/** What a verdict hangs on. */
export interface Facts {
  /** A run completes the level: one of its own, or one that a search found. */
  readonly isCompleted: boolean;
  /** It is proved that nobody can complete it. */
  readonly isImpossible: boolean;
  /** How many runs the level has. */
  readonly runs: number;
  /** Each of them was played to its end. */
  readonly areAllPlayed: boolean;
}

/** The verdict on a level. What a run shows needs no proof; a run that was not played to its end may still complete the level. */
export function verdictOf({ isCompleted, isImpossible, runs, areAllPlayed }: Facts): LevelVerdict {
  if (isCompleted) return 'completable';
  if (isImpossible) return 'impossible';
  return runs > 0 && areAllPlayed ? 'broken' : 'unproven';
}

/** What becomes of a verdict that was given without proofs, once it is known what is proved. */
export const onceProved = (verdict: LevelVerdict, isImpossible: boolean): LevelVerdict =>
  isImpossible && verdict !== 'completable' ? 'impossible' : verdict;
