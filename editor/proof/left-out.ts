import type { LevelProblem } from '../../check/index.ts';
import { type Limit, limitInWords } from './patience.ts';

/**
 * What is said in place of problems that are not known.
 * @param message why a worker, which has more patience, does not know them either; null: it has not been asked, or is not done
 */
export const limitProblem = (limit: Limit, message: string | null): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: message ?? limitInWords(limit),
  hint: limit === 'unchecked' ? 'turn the checks on to have it played' : 'take out objects, aliens above all, or runs',
  pointer: '',
});

/** Of proofs that were not looked for to the end. @param why as a sentence begins */
export const proofsGivenUp = (why: string): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: `${why}: whether something here is out of reach was not proved`,
  hint: 'gq check may look for longer; fewer objects make it quicker',
  pointer: '',
});
