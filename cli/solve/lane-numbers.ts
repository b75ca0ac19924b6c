/**
 * A search consists of this many independent searches, its lanes, each with random numbers of its own. The result does not
 * depend on the number of threads that share the lanes.
 */
export const LANES = 4;

/** The number of the lane that looks for a proof that there is no run; those that look for runs have numbers below. */
export const PROOF_LANE = 1000;

/** A round: the total ticks of each lane, and of the proof lane. */
export interface Round {
  readonly search: number;
  readonly proof: number;
}
