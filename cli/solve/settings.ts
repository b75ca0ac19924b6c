import type { Accuracy } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';

/** What to solve, and how. */
export interface SolveSettings {
  readonly level: Level;
  readonly accuracy: Accuracy;
  readonly goal: Goal;
  readonly objective: Objective;
  readonly seed: number;
  /** The longest run, ticks. */
  readonly maxTicks: number;
  /** The wanted number of really different runs. */
  readonly count: number;
  /** Runs to start from. */
  readonly known: readonly (readonly Hold[])[];
}

/**
 * A search consists of this many independent searches, its lanes, each with random numbers of its own. The result does not
 * depend on the number of threads that share the lanes.
 */
export const LANES = 4;

/** The total ticks of a lane at the end of each round; rounds get longer at first. @param effort limit of all lanes together */
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
