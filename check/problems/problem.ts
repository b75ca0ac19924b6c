import type { Problem } from '../../schema/index.ts';

/** A problem of a level, before its place in the text is known. @template Code which codes it may have */
export type LevelProblem<Code extends string = string> = Omit<Problem, 'code' | 'line' | 'column'> & { readonly code: Code };

/** Words that depend on where problems are read, the command line or the editor: they say what can be done there. */
export interface Hints {
  /** How to give a level its first run. */
  readonly firstRun: string;
  /**
   * Where to see how a run goes: the end of a sentence with its conjunction, or '' where the run is visible anyway.
   * @param name name of the run
   * @returns the words
   */
  readonly seeRun: (name: string) => string;
  /**
   * Where to see how a run ends at each accuracy: the end of a sentence with its conjunction.
   * @param name name of the run
   * @returns the words
   */
  readonly seeAccuracies: (name: string) => string;
  /** What else can be done when a level exceeds the work limit: the end of a sentence with its conjunction. */
  readonly moreWork: string;
  /** What can be done about a proof: the end of a sentence with its conjunction. */
  readonly seeProof: string;
  /** Where to see the places at which the level is lost: the end of a sentence with its conjunction, or ''. */
  readonly seeLost: string;
  /** Words for searches and certificates; absent where there are none. */
  readonly search?: SearchHints;
}

/** Words for the results of a search and of a certificate. */
export interface SearchHints {
  /** How to keep the run that was found: the end of a sentence. */
  readonly keepFound: string;
  readonly nothingFound: string;
  /** How to write down the run with the closest approach: the end of a sentence. */
  readonly nearestRun: (holds: string) => string;
  readonly tightRun: string;
}
