import { TICK_RATE } from '../../engine/basics/index.ts';
import type { Accuracy } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';
import { type AccuracyOptions, chooseAccuracy } from '../accuracy-options.ts';
import type { Configuration } from '../configuration.ts';

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

/** The options that say how to solve a level. */
interface SolveOptions extends AccuracyOptions {
  readonly minerals: Goal['minerals'];
  readonly objective: Objective;
  readonly seed: number;
  /** s */
  readonly maxTime: number;
  readonly count: number;
}

/** What the options and the configuration choose. */
export function askedRuns(options: SolveOptions, configuration: Configuration): AskedRuns {
  const { minerals, objective, seed, maxTime, count } = options;
  const accuracy = chooseAccuracy(options, configuration);
  return { accuracy, goal: { minerals }, objective, seed, maxTicks: Math.round(maxTime * TICK_RATE), count };
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
