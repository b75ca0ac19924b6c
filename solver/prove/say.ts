import { objectName, touchedName } from '../../schema/basics/index.ts';
import type { About, ThingRef } from './proof.ts';

/** Formats a length, rounded to a tenth of a px; whole numbers have no decimals. */
export const px = (length: number): string => `${Math.round(length * 10) / 10} px`;

/** Names what a proof is about, as the subject of a sentence. */
export const subject = (about: About): string =>
  about.kind === 'blackHole' ? 'the black hole' : objectName('mineral', about.index);

/** Names an object that ends a run: `hot asteroid 2`. */
export const thing = ({ kind, index }: ThingRef): string => touchedName(kind, index);
