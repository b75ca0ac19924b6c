import type { Problem } from '../../schema/index.ts';
import type { CheckCode } from '../words/index.ts';

/** A problem of a level, before its place in the text is known. */
export type LevelProblem = Omit<Problem, 'line' | 'column'>;

/** One that only checking a level can show. */
export interface CheckProblem extends LevelProblem {
  readonly code: CheckCode;
}
