import type { Problem } from '../../schema/index.ts';
import type { CheckCode } from '../words/index.ts';

/** A problem of a level, before its place in the text is known. */
export type LevelProblem = Omit<Problem, 'line' | 'column'>;

/** A problem that only a check can find. */
export interface CheckProblem extends LevelProblem {
  readonly code: CheckCode;
}
