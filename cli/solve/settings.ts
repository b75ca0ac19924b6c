import type { Terms } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';
import { type ConfiguredTerms, type TermsOptions, termsFrom } from '../terms.ts';

/** How to solve a level. */
export interface AskedRuns {
  readonly terms: Terms;
  readonly goal: Goal;
  readonly objective: Objective;
  readonly seed: number;
  /** The wanted number of really different runs. */
  readonly count: number;
}

/** The options that say how to solve a level. */
interface SolveOptions extends TermsOptions {
  readonly minerals: Goal['minerals'];
  readonly objective: Objective;
  readonly seed: number;
  readonly count: number;
}

/** What the options and the configuration choose. */
export function askedRuns(options: SolveOptions, configuration: ConfiguredTerms): AskedRuns {
  const { minerals, objective, seed, count } = options;
  return { terms: termsFrom(options, configuration), goal: { minerals }, objective, seed, count };
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
