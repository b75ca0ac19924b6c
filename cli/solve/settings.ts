import type { Accuracy } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';

/** How to solve a level. */
export interface AskedRuns {
  readonly accuracy: Accuracy;
  readonly goal: Goal;
  readonly objective: Objective;
  readonly seed: number;
  /** The longest run, ticks. */
  readonly maxTicks: number;
  /** The wanted number of really different runs. */
  readonly count: number;
}

/** What to solve, and how. */
export interface SolveSettings extends AskedRuns {
  readonly level: Level;
  /** Runs to start from. */
  readonly known: readonly (readonly Hold[])[];
}

/** The search starts from the level's own runs. */
export const settingsFor = (level: Level, asked: AskedRuns): SolveSettings => ({
  ...asked,
  level: { ...level, runs: [] },
  known: level.runs.map(({ holds }) => holds),
});
