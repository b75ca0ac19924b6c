import { changesInWords, diffLevels } from '../../../review/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { titled } from '../document/index.ts';

/** How many changes are named; more are counted. */
const NAMED = 2;
/** the longest text, characters */
const LONGEST = 160;

/**
 * What differs between the texts of two versions, on one line: `Asteroid 3 moved 12 px right; nova 2 removed at (40, 7); 3 more
 * changes`.
 */
export function changesInShort(before: string, after: string): string {
  // both are what the editor wrote out
  const [one, other] = [before, after].map((text): LevelFile => JSON.parse(text));
  const words = changesInWords(diffLevels(one, other), other);
  const rest = words.length - NAMED;
  const named = words.slice(0, NAMED).join('; ');
  const cut = named.length > LONGEST ? `${named.slice(0, LONGEST)}…` : named;
  return titled(rest > 0 ? `${cut}; ${rest} more ${rest === 1 ? 'change' : 'changes'}` : cut);
}
