import { TICK_RATE } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { isWhole, type LiveProof } from '../core/proof/index.ts';

/** How far a run gets. */
export interface Reached {
  /** Ticks until its end, with a fraction; infinite if it was not simulated to its end. */
  readonly until: number;
  /** Whether the run ends without completing the level. */
  readonly isBroken: boolean;
}

export const reachedBy = (proof: LiveProof): Reached => {
  const isPlayed = isWhole(proof);
  return {
    until: isPlayed ? proof.run.time * TICK_RATE : Number.POSITIVE_INFINITY,
    isBroken: isPlayed && proof.run.outcome !== 'completed',
  };
};

/** Whether the run ends before the hold begins. */
export const isMissed = ([press]: Hold, { until }: Reached): boolean => press >= until;

/** Whether the run fails during the hold. */
export const isCut = (hold: Hold, { until, isBroken }: Reached): boolean =>
  isBroken && !isMissed(hold, { until, isBroken }) && hold[1] > until;

/** `3 holds, 1 not reached` */
export function holdsInWords(holds: readonly Hold[], reached: Reached): string {
  const missed = holds.filter((hold) => isMissed(hold, reached)).length;
  const all = `${holds.length} ${holds.length === 1 ? 'hold' : 'holds'}`;
  return missed === 0 ? all : `${all}, ${missed} not reached`;
}
