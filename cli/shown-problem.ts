import type { Problem } from '../schema/index.ts';

/** A problem made ready to be shown: with the lines of the file around it. */
export interface ShownProblem extends Problem {
  readonly frame: string | null;
}

/** Of one file a person is shown so many problems at most. */
export const MAX_SHOWN = 20;
