import { levelOfEntry, type PackEntry, type PackFile } from '../../schema/index.ts';

/** Changes the entries of a pack; everything else of the file stays. */
const withEntries = (pack: PackFile, levels: readonly PackEntry[]): PackFile => ({ ...pack, levels: [...levels] });

/** An entry as it is shown: of the file, or a level that the file does not list. */
interface ShownEntry {
  readonly entry: PackEntry;
  readonly isListed: boolean;
}

/**
 * All entries as they are shown: those of the file, and after them the levels that it does not list.
 *
 * @param pack - the pack
 * @param ids - all levels of the folder, in the order in which unlisted ones are shown
 */
export function shownEntries({ levels }: PackFile, ids: readonly string[]): ShownEntry[] {
  const taken = new Set(levels.flatMap((entry) => levelOfEntry(entry) ?? []));
  return [
    ...levels.map((entry) => ({ entry, isListed: true })),
    ...ids.filter((id) => !taken.has(id)).map((id) => ({ entry: id, isListed: false })),
  ];
}

/**
 * Moves entries to another place, in the order in which they stand. A level that was not listed is then; so are those above it.
 *
 * @param pack - the pack
 * @param ids - all levels of the folder, as in {@link shownEntries}
 * @param moved - the places of the moved entries among the shown ones
 * @param before - the place among the shown ones before which they go; their number: the end
 */
export function moveEntries(pack: PackFile, ids: readonly string[], moved: readonly number[], before: number): PackFile {
  const shown = shownEntries(pack, ids);
  const set = new Set(moved.filter((place) => place >= 0 && place < shown.length));
  const going = shown.filter((_, i) => set.has(i));
  const isStaying = (_: unknown, i: number): boolean => !set.has(i);
  const above = shown.slice(0, before).filter(isStaying);
  const below = shown.slice(before).filter((_, i) => !set.has(before + i));
  const order = [...above, ...going, ...below];
  const last = order.findLastIndex((one) => one.isListed || going.includes(one));
  return withEntries(
    pack,
    order.slice(0, last + 1).map(({ entry }) => entry),
  );
}

/**
 * Moves a level between two others of its folder, whatever stands between them in the pack: down, to right after the one that it then
 * follows; up, to right before the one that then follows it.
 *
 * @param pack - the pack
 * @param ids - all levels, as in {@link shownEntries}
 * @param id - the level
 * @param after - the level of its folder that it follows; null: it is the first
 * @param before - the level of its folder that follows it; null: it is the last
 */
export function moveLevel(
  pack: PackFile,
  ids: readonly string[],
  id: string,
  after: string | null,
  before: string | null,
): PackFile {
  const shown = shownEntries(pack, ids);
  const placeOf = (wanted: string | null): number =>
    shown.findIndex(({ entry }) => wanted !== null && levelOfEntry(entry) === wanted);
  const [from, next, previous] = [placeOf(id), placeOf(before), placeOf(after)];
  const place = previous > from ? previous + 1 : next;
  return from < 0 || place < 0 ? pack : moveEntries(pack, ids, [from], place);
}

/** Lists levels after another one, or at the end; those that are listed already stay where they are. */
export function addLevels(pack: PackFile, ids: readonly string[], after: string | null = null): PackFile {
  const taken = new Set(pack.levels.flatMap((entry) => levelOfEntry(entry) ?? []));
  const news = ids.filter((id) => !taken.has(id));
  const place = after === null ? -1 : pack.levels.findLastIndex((entry) => levelOfEntry(entry) === after);
  const at = place < 0 ? pack.levels.length : place + 1;
  return withEntries(pack, [...pack.levels.slice(0, at), ...news, ...pack.levels.slice(at)]);
}

/** Takes levels out of the list. */
export const removeLevels = (pack: PackFile, ids: readonly string[]): PackFile =>
  withEntries(
    pack,
    pack.levels.filter((entry) => !ids.includes(levelOfEntry(entry) ?? '')),
  );

/** Takes entries out of the list. @param places their places; levels that are not listed have none */
export const removeEntries = (pack: PackFile, places: readonly number[]): PackFile =>
  withEntries(
    pack,
    pack.levels.filter((_, i) => !places.includes(i)),
  );

/** Gives a level another id where it stands; what else its entry says stays. */
export const renameLevel = (pack: PackFile, from: string, to: string): PackFile =>
  withEntries(
    pack,
    pack.levels.map((entry) => {
      if (levelOfEntry(entry) !== from) return entry;
      return typeof entry === 'string' ? to : { ...entry, level: to };
    }),
  );

/** Puts the heading of a new chapter before an entry. */
export const addChapter = (pack: PackFile, before: number, chapter: string): PackFile =>
  withEntries(pack, [...pack.levels.slice(0, before), { chapter }, ...pack.levels.slice(before)]);

/** Renames the chapter at a place, or removes its heading; its levels stay. @param chapter null: it is removed */
export const setChapter = (pack: PackFile, place: number, chapter: string | null): PackFile =>
  withEntries(
    pack,
    pack.levels.flatMap((entry, i): PackEntry[] => {
      if (i !== place || typeof entry !== 'object' || !('chapter' in entry)) return [entry];
      return chapter === null ? [] : [{ ...entry, chapter }];
    }),
  );

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
