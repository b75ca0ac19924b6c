import { inPackOrder } from '../../../check/pack/index.ts';
import { DEFAULT_ACCURACY, DEFAULT_TERMS } from '../../../engine/index.ts';
import {
  type FolderTerms,
  isSame,
  type LevelEntry,
  type ListResponse,
  levelsOfPack,
  type PackOnDisk,
  type PackReading,
  readPack,
} from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';

/** The folder's `pack.json`, as far as it is known: `none` if there is none, `unreadable` with the reason. */
export type FolderPack =
  | { readonly kind: 'none' }
  | { readonly kind: 'unreadable'; readonly file: string; readonly why: string }
  | { readonly kind: 'invalid'; readonly file: string; readonly reading: Extract<PackReading, { ok: false }> }
  | {
      readonly kind: 'valid';
      readonly file: string;
      readonly reading: Extract<PackReading, { ok: true }>;
      /** Why it can't be changed, for people; null if it can. */
      readonly readOnly: string | null;
    };

const NONE: FolderPack = { kind: 'none' };

/** What a `pack.json` is; it is read once. */
const packOf = keptWith(({ file, text, readOnly }: PackOnDisk): FolderPack => {
  if (text === null) return { kind: 'unreadable', file, why: readOnly ?? 'it could not be read' };
  const reading = readPack(text);
  return reading.ok ? { kind: 'valid', file, reading, readOnly } : { kind: 'invalid', file, reading };
});

/** The `pack.json` of a folder; the same object as long as the file is the same. */
export const folderPackIn = ({ list }: { readonly list: ListResponse | null }): FolderPack =>
  list?.pack === undefined ? NONE : packOf(list.pack);

/**
 * The list with its levels as its pack puts them in order; a pack that is not valid says nothing.
 * @param former the earlier ids of renamed levels: they keep their places until the pack has the new ones
 */
export function inOrderOfPack(list: ListResponse, former: ReadonlyMap<string, string>): ListResponse {
  const pack = folderPackIn({ list });
  if (pack.kind !== 'valid') return list;
  const listed = levelsOfPack(pack.reading.pack);
  const placeIn = ({ id }: LevelEntry): string => {
    const before = former.get(id);
    return before === undefined || listed.includes(id) || list.levels.some((other) => other.id === before) ? id : before;
  };
  const levels = inPackOrder<LevelEntry>(list.levels, placeIn, listed);
  return levels.every((entry, i) => entry === list.levels[i]) ? list : { ...list, levels };
}

/** A list whose pack is the same object as before if it is equal, so that subscribers see no change. */
export function withKeptPack(list: ListResponse, before: ListResponse | null): ListResponse {
  const old = before?.pack;
  if (old === undefined || list.pack === undefined || old === list.pack) return list;
  const isSame = old.etag === list.pack.etag && old.text === list.pack.text && old.readOnly === list.pack.readOnly;
  return isSame ? { ...list, pack: old } : list;
}

const { maxTime, maxWork, rules } = DEFAULT_TERMS;

/** For levels in folders without a configuration. */
export const NO_FOLDER_TERMS: FolderTerms = { file: null, accuracy: DEFAULT_ACCURACY, maxTime, maxWork, rules, problems: [] };

/** The terms under which the folder's levels are judged; the defaults before there is a list. */
export const folderTermsIn = ({ list }: { readonly list: ListResponse | null }): FolderTerms => list?.terms ?? NO_FOLDER_TERMS;

/** A list whose terms are the same objects as before if they are equal, so that subscribers see no change. */
export function withKeptTerms(list: ListResponse, before: ListResponse | null): ListResponse {
  const old = before?.terms;
  if (old === undefined || old === list.terms) return list;
  if (isSame(old, list.terms)) return { ...list, terms: old };
  return isSame(old.rules, list.terms.rules) ? { ...list, terms: { ...list.terms, rules: old.rules } } : list;
}

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
