import type { RunEnd } from '../../../check/words/index.ts';
import { endInWords, isWhole, type LiveProof, type NearMiss } from '../../core/proof/index.ts';

/** What is known of a run, to compare it with another. */
export interface Figures {
  /** How it ends; null: it was not simulated to its end. */
  readonly end: RunEnd | null;
  /** Range of the level, px. */
  readonly range: number;
  /** Why the end is not known, in words; '' if it is. */
  readonly unknown: string;
  /** How many minerals it collects, and how many there are. */
  readonly taken: number;
  readonly minerals: number;
  /** Where she is nearest to a hazard at any tick, as in the inspector; null: the level has none. */
  readonly closest: NearMiss | null;
}

/** The figures of the shown run. The distances are computed, so its arrays must still be valid. */
export function figuresOf(proof: LiveProof): Figures {
  const { run, level } = proof;
  const { outcome, with: touched, time, tick } = run;
  const isKnown = isWhole(proof);
  return {
    end: isKnown ? { outcome, with: touched, time, tick } : null,
    range: level.range,
    unknown: isKnown ? '' : endInWords(proof),
    taken: run.minerals.length,
    minerals: level.minerals.length,
    closest: isKnown ? proof.margins.closest : null,
  };
}
