import type { Terms } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Closest, Effort, Goal, Objective, Proof, Robustness, Solution } from '../../solver/index.ts';
import type { ConfiguredTerms } from '../config/index.ts';
import { type TermsOptions, termsFrom } from '../options/index.ts';

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

/** The data that a worker thread starts with. */
export interface WorkerData {
  readonly settings: SolveSettings;
  /** The lanes of this worker. */
  readonly lanes: readonly number[];
  /** An Int32; any value but 0 is a request to stop soon. */
  readonly stop: SharedArrayBuffer;
}

/** A request to a worker; each gets one answer. */
export type Request =
  | { readonly kind: 'advance'; readonly round: Round }
  | { readonly kind: 'measure'; readonly holds: readonly Hold[] };

export interface LaneState {
  readonly lane: number;
  readonly effort: Effort;
  readonly closest: Closest | null;
  readonly solutions: readonly Solution[];
  /** A proof that there is no run; null if there is none. */
  readonly impossible: Proof | null;
  /** Whether nothing can improve any more. */
  readonly finished: boolean;
}

export type Answer =
  | { readonly kind: 'advance'; readonly lanes: readonly LaneState[] }
  | { readonly kind: 'measure'; readonly robustness: Robustness }
  | { readonly kind: 'failed'; readonly why: string };
