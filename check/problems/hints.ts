import type { FirstIndex } from '../words/index.ts';

/** What differs by the place where problems are read: how things are numbered there, and what can be done there. */
export interface Hints {
  /** The number of the first object of a kind. */
  readonly first: FirstIndex;
  /** How a level gets its first run. */
  readonly firstRun: string;
  /** Where to see how a run goes: the end of a sentence, with what joins it; '' where it is seen anyway. */
  readonly seeRun: (name: string) => string;
  /** Where to see what each accuracy makes of a run: likewise. */
  readonly seeAccuracies: (name: string) => string;
  /** What else may be done where a level costs too much work: likewise. */
  readonly moreWork: string;
  /** What to do about what is proved: likewise. */
  readonly seeProof: string;
  /** Left out where nothing is searched for, and no slack is asked for. */
  readonly search?: SearchHints;
}

/** Hints to what a search and a certificate come to. */
export interface SearchHints {
  /** How the run that was found is kept: the end of a sentence. */
  readonly keepFound: string;
  readonly nothingFound: string;
  /** How the nearest run that a search tried is written there: the end of a sentence. */
  readonly nearestRun: (holds: string) => string;
  readonly tightRun: string;
}
