import { decodePlay, levelHash, type Play, playFromText, verifyPlay } from 'gravity-quest-toolkit/game';
import { levelTextOf } from 'gravity-quest-toolkit/phaser';
import { type Level, type PlayableEntry, readLevelText, type Terms, termsOf, USUAL_TERMS } from './pack.ts';

/** A part of the fragment of a link, such as `play=…` of `#level=…&play=…`; null: the link has none. */
export const partOf = (fragment: string, key: string): string | null =>
  fragment
    .replace(/^#/, '')
    .split('&')
    .find((part) => part.startsWith(`${key}=`)) ?? null;

const textOf = (fragment: string, key: string): string | null => partOf(fragment, key)?.slice(key.length + 1) ?? null;

/** Under which terms the level of a link is played: `#level=…&accuracy=arcade&max-time=120`. */
function termsInLink(fragment: string): Terms | { problem: string } {
  const accuracy = textOf(fragment, 'accuracy') ?? USUAL_TERMS.accuracy;
  const maxTime = textOf(fragment, 'max-time');
  return termsOf(accuracy, maxTime === null ? USUAL_TERMS.maxTime : Number(maxTime));
}

/** A level of a link, and the terms under which it is played; null: the link has none. */
export async function levelInLink(fragment: string): Promise<{ level: Level; terms: Terms } | { problem: string } | null> {
  const found = await levelTextOf(fragment);
  if (found === null) return null;
  if (!found.ok) return { problem: `The link can't be opened: ${found.message}.` };
  const reading = readLevelText(found.text);
  const terms = termsInLink(fragment);
  if ('problem' in terms) return { problem: `The link can't be opened: ${terms.problem}.` };
  return 'level' in reading ? { ...reading, terms } : { problem: `The link contains no valid level: ${reading.problem}.` };
}

/** The text of the play in a link; null: the link has none. */
export function playInLink(fragment: string): string | null {
  return textOf(fragment, 'play');
}

/** A play of somebody, and the level it belongs to. */
export type ReadPlay = { readonly entry: PlayableEntry; readonly play: Play } | { readonly problem: string };

/**
 * Reads a play, finds its level, and repeats it: it must be what it claims, at the accuracy of this page. A play at another one
 * would go on differently here.
 */
export function readPlay(bytes: Uint8Array | null, entries: readonly PlayableEntry[], { accuracy }: Terms): ReadPlay {
  const damaged = (why: string) => ({ problem: `The play can't be shown: ${why}.` });
  if (bytes === null) return damaged('it is damaged, perhaps because the link was cut off');
  const decoded = decodePlay(bytes);
  if (!decoded.ok) return damaged(decoded.message);
  const entry = entries.find(({ level }) => levelHash(level) === decoded.play.level);
  if (entry === undefined) return damaged('it belongs to a level that is not here, or to another version of one');
  const { verdict, message } = verifyPlay(entry.level, bytes, { accuracy });
  return verdict === 'ok' ? { entry, play: decoded.play } : damaged(message);
}

export const readPlayText = (text: string, entries: readonly PlayableEntry[], terms: Terms): ReadPlay =>
  readPlay(playFromText(text), entries, terms);
