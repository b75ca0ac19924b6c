import type { Accuracy } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';

/** What is to be solved, and how. */
export interface SolveSettings {
  readonly level: Level;
  readonly accuracy: Accuracy;
  readonly goal: Goal;
  readonly objective: Objective;
  readonly seed: number;
  /** How long a run may last, ticks. */
  readonly maxTicks: number;
  /** How many really different runs are wanted. */
  readonly count: number;
  /** Runs to start from. */
  readonly known: readonly (readonly Hold[])[];
}

/**
 * A search is made of so many independent ones, its lanes, each with random numbers of its own. However many threads share them,
 * what they find together is the same.
 */
export const LANES = 4;

/** Ticks that each lane has simulated by the end of a round, all lanes together at most `effort`; more and more at first. */
export function* rounds(effort: number | null): Generator<number> {
  const most = effort === null ? Number.POSITIVE_INFINITY : Math.ceil(effort / LANES);
  let total = 0;
  let step = 20_000;
  while (total < most) {
    total = Math.min(most, total + step);
    step = Math.min(500_000, 2 * step);
    yield total;
  }
}
