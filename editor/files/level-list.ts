import type { LevelEntry } from '../../schema/index.ts';

/** The folder that a level is in: `world` of `world/loop`, '' of `loop`. */
export const folderOf = (id: string): string => id.slice(0, Math.max(0, id.lastIndexOf('/')));

/** The ids of the levels in a folder, in their order. */
export const idsIn = (levels: readonly { readonly id: string }[], folder: string): string[] =>
  levels.flatMap(({ id }) => (folderOf(id) === folder ? [id] : []));

/** With an entry in its place; where that is, the storage says for certain. @param from the id that it had */
export function withEntry(levels: readonly LevelEntry[], entry: LevelEntry, from: string): LevelEntry[] {
  const index = levels.findIndex(({ id }) => id === from);
  return index < 0 ? [...levels, entry] : levels.map((other, i) => (i === index ? entry : other));
}

/**
 * With a part of a list that comes in parts: until the last one what was known stays on the screen.
 * @param heard ids of all parts so far, those of this one included
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

/** With some of the levels in another order, in the places that they have together. */
export function inOrder(levels: readonly LevelEntry[], ids: readonly string[]): LevelEntry[] {
  const wanted = new Set(ids);
  const ordered = ids.flatMap((id) => levels.find((entry) => entry.id === id) ?? []);
  return levels.map((entry) => (wanted.has(entry.id) ? (ordered.shift() ?? entry) : entry));
}
