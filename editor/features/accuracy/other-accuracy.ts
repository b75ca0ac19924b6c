import { withinWork } from '../../../check/index.ts';
import { ACCURACIES, type AccuracyName, atAccuracy, createSimulation, maxTicksOf, WorkBudget } from '../../../engine/index.ts';
import { largestDistance, pathOf } from '../../../engine/work-precision/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

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
export function otherEndOf({ scene, terms, run, limit }: LiveProof, most = MOST_WORK): OtherEnd | null {
  if (limit === 'unchecked' || limit === 'everything') return null;
  const name: AccuracyName = terms.accuracy.name === 'arcade' ? 'precise' : 'arcade';
  const budget = new WorkBudget(most);
  const maxTicks = maxTicksOf(terms);
  return withinWork(budget, () => {
    const shown = pathOf(createSimulation(scene, budget), run.holds, maxTicks);
    const other = pathOf(createSimulation(atAccuracy(scene, ACCURACIES[name]), budget), run.holds, maxTicks);
    const isSame = shown.ending?.outcome === other.ending?.outcome;
    return { name, distance: largestDistance(other, shown), isSame };
  });
}
