import type { FailureCause } from '../../../check/plays/index.ts';
import { bodyInWords } from '../../../check/words/index.ts';

/** Why she fails, to follow "she": `hits nova 3`, `is lost`. */
export const causeInWords = ({ kind, index }: FailureCause): string => {
  if (index !== null) return `hits ${bodyInWords({ kind, index })}`;
  if (kind === 'lost') return 'is lost';
  if (kind === 'timeout') return 'runs out of time';
  return kind === 'left' ? 'is left before the end' : 'collects too few minerals';
};
