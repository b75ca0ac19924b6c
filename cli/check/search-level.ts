import type { Searched } from '../../check/index.ts';
import type { Scene } from '../../engine/index.ts';
import { createDecider, type Proof } from '../../solver/index.ts';
import type { CheckSettings, SearchSettings } from './checked-level.ts';

/** Simulated ticks between two looks at the clock. */
const SLICE = 50_000;

/** What a search found. */
export interface LevelSearch extends Searched {
  /** A proof that there is no run, found beside the search; null if there is none. */
  readonly impossible: Proof | null;
  /** Whether the clock ended it: another search with the same settings may find more or less. */
  readonly isOutOfTime: boolean;
}

/**
 * Searches for a run that completes a level: for any run, or if slack is required, for the most robust one. As long as there is
 * none, half of the work goes into proofs with ever finer sets.
 * Blocks the calling thread for as long as the limits allow.
 */
export function searchLevel(scene: Scene, { limits, seed }: SearchSettings, { requireSlack }: CheckSettings): LevelSearch {
  const objective = requireSlack === null ? 'first' : 'robust';
  const end = limits.budget === null ? Number.POSITIVE_INFINITY : performance.now() + 1000 * limits.budget;
  const isLate = (): boolean => performance.now() >= end;
  const effort = limits.effort ?? undefined;
  const decider = createDecider(scene, { objective, seed, effort, isStopped: isLate });
  while (!decider.finished && !isLate()) decider.advance(SLICE);
  const { best, impossible, closest, finished } = decider;
  return { found: best?.holds ?? null, impossible, effort: { ...decider.effort }, closest, isOutOfTime: !finished };
}
