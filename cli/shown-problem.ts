import type { Problem } from '../schema/index.ts';

/** A problem with the surrounding lines of the file. */
export interface ShownProblem extends Problem {
  readonly frame: string | null;
  /** Where it is, by ids and names instead of indices; left out where a problem has no pointer into a file. */
  readonly key?: string;
}

/** The largest number of problems that are shown for one file. */
export const MAX_SHOWN = 20;
