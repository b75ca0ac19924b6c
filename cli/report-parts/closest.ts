import { closestInWords, holdsInWords } from '../../check/words/index.ts';
import type { Closest } from '../../solver/index.ts';

/** A run as an option gives it: the end of a sentence. */
export const byHolds = (holds: string): string => `, with --holds ${holds}`;

/** How near any run came, and which. */
export const closestRunInWords = (closest: Closest): string => closestInWords(closest) + byHolds(holdsInWords(closest.holds));
