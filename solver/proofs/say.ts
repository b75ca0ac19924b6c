import type { About, ThingRef } from './proof.ts';

const LISTS = { nova: 'novae', asteroid: 'asteroids', alien: 'aliens' } as const;

/** Formats a length, rounded to a tenth of a px; whole numbers have no decimals. */
export const px = (length: number): string => `${Math.round(length * 10) / 10} px`;

/** Names what a proof is about, as the subject of a sentence. */
export const subject = (about: About): string => (about.kind === 'blackHole' ? 'the black hole' : `minerals[${about.index}]`);

/** Names an object by its place in the level file. */
export const thing = ({ kind, index }: ThingRef): string =>
  kind === 'blackHole' ? 'the black hole' : `${LISTS[kind]}[${index}]`;
