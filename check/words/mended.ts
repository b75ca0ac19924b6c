import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import type { Mended } from '../mend/index.ts';
import { proposalInWords } from './proposal.ts';
import { takenBackInWords } from './taken-back.ts';

/**
 * What mends a level, as an instruction.
 * @param after the file that is mended
 */
export const mendedInWords = ({ how }: Mended, after: LevelFile): string =>
  how.kind === 'back' ? takenBackInWords(how.taken, after) : proposalInWords(resolveLevel(after), how.proposal);
