import type { LevelProblem } from '../../../check/index.ts';
import { type Limit, limitInWords } from './patience.ts';

/**
 * The problem that stands for problems that are not known.
 * @param message why a worker, which has more patience, does not know them either; null: not asked, or not done
 */
export const limitProblem = (limit: Limit, message: string | null): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: message ?? limitInWords(limit),
  hint: limit === 'unchecked' ? 'turn checks on to simulate it' : 'delete objects, aliens above all, or runs',
  pointer: '',
});

/** The problem for proofs whose search ended early. @param why the beginning of a sentence */
export const proofsGivenUp = (why: string): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: `${why}: the page could not decide whether something is out of reach`,
  hint: 'gq check may search longer; fewer objects make it faster',
  pointer: '',
});
