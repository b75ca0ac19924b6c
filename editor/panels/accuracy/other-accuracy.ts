import { withinWork } from '../../../check/index.ts';
import { type AccuracyName, compile, createSimulation, DEFAULT_MAX_TICKS, WorkBudget } from '../../../engine/index.ts';
import { largestDistance, pathOf } from '../../../engine/work-precision/index.ts';
import type { LiveProof } from '../../proof/index.ts';

/** How the shown run goes at another accuracy. */
export interface OtherEnd {
  readonly name: AccuracyName;
  /** The largest distance between the two paths at the same tick, px. */
  readonly distance: number;
  /** Whether both have the same outcome. */
  readonly isSame: boolean;
}

/**
 * Pieces of motion that the comparison may take: about 0.1 s. Not a time, as one slow moment of the machine would decide
 * whether a level is ever compared.
 */
const MOST_WORK = 20_000;

/**
 * Compares the shown run at the current accuracy with `arcade`, or `arcade` with `precise`.
 * @param most pieces of motion that both runs together may take
 * @returns null if they take more, or if the level is not simulated at all
 */
export function otherEndOf({ level, scene, accuracy, run, limit }: LiveProof, most = MOST_WORK): OtherEnd | null {
  if (limit === 'unchecked' || limit === 'everything') return null;
  const name: AccuracyName = accuracy === 'arcade' ? 'precise' : 'arcade';
  const budget = new WorkBudget(most);
  return withinWork(budget, () => {
    const shown = pathOf(createSimulation(scene, budget), run.holds, DEFAULT_MAX_TICKS);
    const other = pathOf(createSimulation(compile(level, name), budget), run.holds, DEFAULT_MAX_TICKS);
    const isSame = shown.ending?.outcome === other.ending?.outcome;
    return { name, distance: largestDistance(other, shown), isSame };
  });
}
