import type { PackFile } from '../../schema/index.ts';

/**
 * Puts things into the order of a pack: those that it lists first, the others after them in the order in which they come.
 *
 * @param things - anything that stands for a level
 * @param idOf - the id of the level
 * @param listed - the ids in the order of the pack, each once
 */
export function inPackOrder<T>(things: readonly T[], idOf: (thing: T) => string, listed: readonly string[]): T[] {
  const places = new Map(listed.map((id, place) => [id, place]));
  const placeOf = (thing: T): number => places.get(idOf(thing)) ?? listed.length;
  // sorting is stable, so what is not listed keeps its order
  return [...things].sort((a, b) => placeOf(a) - placeOf(b));
}

/** The chapter of each level of a pack, by id; none for those before the first heading. */
export function chaptersOf({ levels }: Pick<PackFile, 'levels'>): ReadonlyMap<string, string> {
  const chapters = new Map<string, string>();
  let chapter: string | null = null;
  for (const entry of levels) {
    if (typeof entry === 'object' && 'chapter' in entry) {
      chapter = entry.chapter;
      continue;
    }
    const id = typeof entry === 'string' ? entry : entry.level;
    if (chapter !== null && !chapters.has(id)) chapters.set(id, chapter);
  }
  return chapters;
}
