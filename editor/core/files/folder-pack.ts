import { inPackOrder } from '../../../check/pack/index.ts';
import {
  type LevelEntry,
  type ListResponse,
  levelsOfPack,
  type PackOnDisk,
  type PackReading,
  readPack,
} from '../../../schema/index.ts';

const readings = new WeakMap<PackOnDisk, PackReading | null>();

/** What a `pack.json` says; null if it could not be read. It is read once. */
function readingOf(pack: PackOnDisk): PackReading | null {
  let reading = readings.get(pack);
  if (reading === undefined) {
    reading = pack.text === null ? null : readPack(pack.text);
    readings.set(pack, reading);
  }
  return reading;
}

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
const known = new WeakMap<PackOnDisk, FolderPack>();

/** The `pack.json` of a folder; the same object as long as the file is the same. */
export function folderPackIn({ list }: { readonly list: ListResponse | null }): FolderPack {
  const pack = list?.pack;
  if (pack === undefined) return NONE;
  let found = known.get(pack);
  if (found === undefined) {
    const reading = readingOf(pack);
    const { file, readOnly } = pack;
    if (reading === null) found = { kind: 'unreadable', file, why: readOnly ?? 'it could not be read' };
    else if (reading.ok) found = { kind: 'valid', file, reading, readOnly };
    else found = { kind: 'invalid', file, reading };
    known.set(pack, found);
  }
  return found;
}

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
