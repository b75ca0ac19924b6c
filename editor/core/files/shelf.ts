import {
  LEVEL_ID_PART,
  type LevelEntry,
  type ListResponse,
  PACK_NAME,
  type PackOnDisk,
  type ReadResponse,
  type TrashEntry,
} from '../../../schema/index.ts';
import { readText } from './disk-text.ts';
import { NO_FOLDER_TERMS } from './folder-terms.ts';
import { type StorageError, storageError } from './level-storage.ts';

/** A level, or the order of the levels, in the browser's storage. */
export interface StoredLevel {
  readonly text: string;
  /** The etag; it grows with every write. */
  readonly version: number;
}

/** All levels in the browser's storage. */
export interface Shelf {
  /** In order of play; a Map, as an object would put numeric names first. */
  readonly levels: ReadonlyMap<string, StoredLevel>;
  readonly trash: readonly (TrashEntry & { readonly text: string })[];
  /** The text of `pack.json`; null or missing: there is none. */
  readonly pack?: StoredLevel | null;
  /** The last version number in use. */
  readonly version: number;
}

/** The initial state. */
export const EMPTY: Shelf = { levels: new Map(), trash: [], version: 0 };

const etagOf = ({ version }: StoredLevel): string => `"${version.toString(16).padStart(64, '0')}"`;

/** Thrown when a request is refused. */
export class Refused extends Error {
  constructor(readonly error: StorageError) {
    super(error.message);
  }
}

/** The list entry of a level. */
export function entryOf(id: string, level: StoredLevel): LevelEntry {
  const reading = readText(level.text);
  return {
    id,
    file: `${id}.level.json`,
    etag: etagOf(level),
    status: reading.ok ? 'valid' : 'invalid',
    name: reading.ok ? reading.file.name : null,
    problems: reading.ok ? [] : [...reading.problems],
    readOnly: null,
  };
}

/** The order of the levels, as a storage lists it; null if there is none. */
export const packOf = ({ pack }: Shelf): PackOnDisk | null =>
  pack == null ? null : { file: PACK_NAME, etag: etagOf(pack), text: pack.text, readOnly: null };

/** All levels, as a storage lists them. */
export const listOf = (shelf: Shelf): ListResponse => ({
  folder: { id: 'this-browser', path: 'this browser', $schema: null },
  folders: [''],
  terms: NO_FOLDER_TERMS,
  levels: [...shelf.levels].map(([id, level]) => entryOf(id, level)),
  ...packed(shelf),
  troubles: [],
  unread: 0,
});

function packed(shelf: Shelf): Pick<ListResponse, 'pack'> {
  const pack = packOf(shelf);
  return pack === null ? {} : { pack };
}

/** @throws Refused if there is no such level */
export function mustExist(shelf: Shelf, id: string): StoredLevel {
  const level = shelf.levels.get(id);
  if (level !== undefined) return level;
  throw new Refused(
    storageError('unknown-level', `there is no level ${JSON.stringify(id)} in this browser`, 'it was deleted or renamed'),
  );
}

/** @throws Refused if it has changed since it was read */
export function mustFit(shelf: Shelf, id: string, base: string): StoredLevel {
  const level = mustExist(shelf, id);
  if (etagOf(level) === base) return level;
  const current: ReadResponse = { ...entryOf(id, level), text: level.text };
  throw new Refused(storageError('conflict', `${id} has changed since it was read`, 'merge the two versions', { current }));
}

/** @throws Refused if it is not a valid name or is taken */
export function mustBeFree(shelf: Shelf, id: string): void {
  if (!LEVEL_ID_PART.test(id)) {
    throw new Refused(
      storageError('bad-name', `a level can't be called ${JSON.stringify(id)}`, 'use letters, digits, -, _ and spaces'),
    );
  }
  if ([...shelf.levels.keys()].some((other) => other.toLowerCase() === id.toLowerCase())) {
    throw new Refused(storageError('name-taken', `a level ${JSON.stringify(id)} already exists`, 'choose another name'));
  }
}

/** All levels but one. */
export const without = ({ levels }: Shelf, id: string) => new Map([...levels].filter(([name]) => name !== id));

/** Puts a level on the shelf: in place of `at`, or at the end. */
export function withLevel(shelf: Shelf, id: string, text: string, at: string | null = null): Shelf {
  const version = shelf.version + 1;
  const level = { text, version };
  const entries = [...shelf.levels];
  const levels =
    at === null ? [...entries, [id, level] as const] : entries.map((entry) => (entry[0] === at ? ([id, level] as const) : entry));
  return { ...shelf, levels: new Map(levels), version };
}
