import { closestInWords, holdsInWords } from '../../check/words/index.ts';
import type { Closest } from '../../solver/index.ts';

/** A run as an option, for the end of a sentence. */
export const byHolds = (holds: string): string => `, with --holds ${holds}`;

/** Says how close the closest run came, and which run that is. */
export const closestRunInWords = (closest: Closest): string => closestInWords(closest) + byHolds(holdsInWords(closest.holds));
