import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { proposalInWords } from '../words/index.ts';
import type { Mended } from './mend.ts';
import { takenBackInWords } from './taken-back-in-words.ts';

/**
 * What mends a level, as an instruction.
 * @param after the file that is mended
 */
export const mendedInWords = ({ how }: Mended, after: LevelFile): string =>
  how.kind === 'back' ? takenBackInWords(how.taken, after) : proposalInWords(resolveLevel(after), how.proposal);
