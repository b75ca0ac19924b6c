import type { LevelEntry } from '../../../schema/index.ts';

/** The folder of a level: `world` of `world/loop`, '' of `loop`. */
export const folderOf = (id: string): string => id.slice(0, Math.max(0, id.lastIndexOf('/')));

/** The ids of the levels in a folder, in order. */
export const idsIn = (levels: readonly { readonly id: string }[], folder: string): string[] =>
  levels.flatMap(({ id }) => (folderOf(id) === folder ? [id] : []));

/** The list with an entry updated in place; its final place comes from the storage. @param from the id that it had */
export function withEntry(levels: readonly LevelEntry[], entry: LevelEntry, from: string): LevelEntry[] {
  const index = levels.findIndex(({ id }) => id === from);
  return index < 0 ? [...levels, entry] : levels.map((other, i) => (i === index ? entry : other));
}

/**
 * The list with a part of a new list that arrives in parts: until the last part, known levels stay on the screen.
 * @param heard ids of all parts so far, including this one
 * @param isWhole whether this is the last part
 */
export function withPart(
  known: readonly LevelEntry[],
  part: readonly LevelEntry[],
  heard: ReadonlySet<string>,
  isWhole: boolean,
): LevelEntry[] {
  const reported = new Map(part.map((entry) => [entry.id, entry]));
  if (isWhole && reported.size === heard.size) return [...part];
  const kept = known.filter(({ id }) => !isWhole || heard.has(id)).map((entry) => reported.get(entry.id) ?? entry);
  const before = new Set(known.map(({ id }) => id));
  return [...kept, ...part.filter(({ id }) => !before.has(id))];
}

/** The list with some levels reordered among their places. */
export function inOrder(levels: readonly LevelEntry[], ids: readonly string[]): LevelEntry[] {
  const wanted = new Set(ids);
  const ordered = ids.flatMap((id) => levels.find((entry) => entry.id === id) ?? []);
  return levels.map((entry) => (wanted.has(entry.id) ? (ordered.shift() ?? entry) : entry));
}
