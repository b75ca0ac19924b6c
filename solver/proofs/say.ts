import type { About, ThingRef } from './proof.ts';

const LISTS = { nova: 'novae', asteroid: 'asteroids', alien: 'aliens' } as const;

/** A length as people read it: rounded to a tenth, whole where it may be. */
export const px = (length: number): string => `${Math.round(length * 10) / 10} px`;

/** What a proof is about, as a sentence begins. */
export const subject = (about: About): string => (about.kind === 'blackHole' ? 'the black hole' : `minerals[${about.index}]`);

/** A thing as the level file names it. */
export const thing = ({ kind, index }: ThingRef): string =>
  kind === 'blackHole' ? 'the black hole' : `${LISTS[kind]}[${index}]`;
