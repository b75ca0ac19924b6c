import { decodePlay, levelHash, type Play, playFromText, verifyPlay } from 'gravity-quest-toolkit/game';
import { levelTextOf } from 'gravity-quest-toolkit/phaser';
import { type Level, type PlayableEntry, readLevelText } from './pack.ts';

/** A part of the fragment of a link, such as `play=…` of `#level=…&play=…`; null: the link has none. */
export const partOf = (fragment: string, key: string): string | null =>
  fragment
    .replace(/^#/, '')
    .split('&')
    .find((part) => part.startsWith(`${key}=`)) ?? null;

/** A level of a link; null: the link has none. */
export async function levelInLink(fragment: string): Promise<{ level: Level } | { problem: string } | null> {
  const found = await levelTextOf(fragment);
  if (found === null) return null;
  if (!found.ok) return { problem: `The link can't be opened: ${found.message}.` };
  const reading = readLevelText(found.text);
  return 'level' in reading ? reading : { problem: `The link contains no valid level: ${reading.problem}.` };
}

/** The text of the play in a link; null: the link has none. */
export function playInLink(fragment: string): string | null {
  return partOf(fragment, 'play')?.slice('play='.length) ?? null;
}

/** A play of somebody, and the level it belongs to. */
export type ReadPlay = { readonly entry: PlayableEntry; readonly play: Play } | { readonly problem: string };

/** Reads a play, finds its level, and repeats it: it must be what it claims. */
export function readPlay(bytes: Uint8Array | null, entries: readonly PlayableEntry[]): ReadPlay {
  const damaged = (why: string) => ({ problem: `The play can't be shown: ${why}.` });
  if (bytes === null) return damaged('it is damaged, perhaps because the link was cut off');
  const decoded = decodePlay(bytes);
  if (!decoded.ok) return damaged(decoded.message);
  const entry = entries.find(({ level }) => levelHash(level) === decoded.play.level);
  if (entry === undefined) return damaged('it belongs to a level that is not here, or to another version of one');
  const { verdict, message } = verifyPlay(entry.level, bytes);
  return verdict === 'ok' ? { entry, play: decoded.play } : damaged(message);
}

export const readPlayText = (text: string, entries: readonly PlayableEntry[]): ReadPlay => readPlay(playFromText(text), entries);
