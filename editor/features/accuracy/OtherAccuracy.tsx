import { withinWork } from '../../../check/index.ts';
import { ACCURACIES, type AccuracyName, atAccuracy, createSimulation, maxTicksOf, WorkBudget } from '../../../engine/index.ts';
import { largestDistance, pathOf } from '../../../engine/work-precision/index.ts';
import { useProofAtRest } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

/** ms without a change before the comparison, which simulates two whole runs */
const REST = 300;

const compared = (proof: LiveProof) => otherEndOf(proof);

const px = (distance: number): string => (distance >= 0.05 ? distance.toFixed(1) : distance.toPrecision(1));

/** Whether another accuracy would give the same outcome for the shown run, in a few words. */
export function OtherAccuracy() {
  const other = useProofAtRest(compared, REST);
  if (other === null) return null;
  const { name, distance, isSame } = other;
  return (
    <span className={isSame ? undefined : 'tone--warn'}>
      {isSame ? `${name} would differ by ${px(distance)} px, same verdict` : `${name} would end differently`}
    </span>
  );
}

/** How the shown run goes at another accuracy. */
interface OtherEnd {
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
