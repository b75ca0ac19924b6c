import {
  type DeleteResponse,
  type EditEvent,
  LEVEL_ID_PART,
  type LevelEntry,
  type ListResponse,
  type OrderResponse,
  PACK_NAME,
  type PackOnDisk,
  type ReadResponse,
  readPack,
  type TrashEntry,
} from '../../../schema/index.ts';
import { NO_FOLDER_TERMS } from './folder-list.ts';
import { type StorageError, storageError } from './level-storage.ts';
import { readText } from './read-text.ts';

/** A level, or the order of the levels, in the browser's storage. */
interface StoredLevel {
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
const packOf = ({ pack }: Shelf): PackOnDisk | null =>
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
function mustFit(shelf: Shelf, id: string, base: string): StoredLevel {
  const level = mustExist(shelf, id);
  if (etagOf(level) === base) return level;
  const current: ReadResponse = { ...entryOf(id, level), text: level.text };
  throw new Refused(storageError('conflict', `${id} has changed since it was read`, 'merge the two versions', { current }));
}

/** @throws Refused if it is not a valid name or is taken */
function mustBeFree(shelf: Shelf, id: string): void {
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
const without = ({ levels }: Shelf, id: string) => new Map([...levels].filter(([name]) => name !== id));

/** Puts a level on the shelf: in place of `at`, or at the end. */
function withLevel(shelf: Shelf, id: string, text: string, at: string | null = null): Shelf {
  const version = shelf.version + 1;
  const level = { text, version };
  const entries = [...shelf.levels];
  const levels =
    at === null ? [...entries, [id, level] as const] : entries.map((entry) => (entry[0] === at ? ([id, level] as const) : entry));
  return { ...shelf, levels: new Map(levels), version };
}

/**
 * The result of a change: the new shelf, the answer, and the event for other pages. Changes throw `Refused` if they are not
 * possible.
 */
export interface ShelfChange<T> {
  readonly shelf: Shelf;
  readonly value: T;
  readonly event: EditEvent;
}

/** @param base etag of the version to replace; null for a new level */
export function writeLevel(shelf: Shelf, id: string, text: string, base: string | null): ShelfChange<LevelEntry> {
  mustBeValid(text);
  if (base === null) mustBeFree(shelf, id);
  else mustFit(shelf, id, base);
  return changed(withLevel(shelf, id, text, base === null ? null : id), id);
}

export function renameLevel(shelf: Shelf, id: string, to: string, base: string): ShelfChange<LevelEntry> {
  const level = mustFit(shelf, id, base);
  mustBeFree({ ...shelf, levels: without(shelf, id) }, to);
  const levels = new Map([...shelf.levels].map(([name, other]) => (name === id ? [to, level] : [name, other])));
  const next = { ...shelf, levels };
  const entry = entryOf(to, mustExist(next, to));
  return { shelf: next, value: entry, event: { type: 'renamed', from: id, entry, by: null } };
}

export function duplicateLevel(shelf: Shelf, id: string, to: string, base: string): ShelfChange<LevelEntry> {
  mustBeFree(shelf, to);
  return changed(withLevel(shelf, to, mustFit(shelf, id, base).text), to);
}

/** Moves a level to the trash. @param now ms since 1970 */
export function removeLevel(shelf: Shelf, id: string, base: string, now: number): ShelfChange<DeleteResponse> {
  const { text } = mustFit(shelf, id, base);
  const version = shelf.version + 1;
  const trashed: TrashEntry = { trash: `${id}~${version}`, id, deleted: new Date(now).toISOString() };
  const trash = [{ ...trashed, text }, ...shelf.trash];
  const next = { ...shelf, levels: without(shelf, id), trash, version };
  return { shelf: next, value: { trashed }, event: { type: 'removed', id, by: null } };
}

/** @param name of an entry of the trash @param to its new id; by default its old one */
export function restoreLevel(shelf: Shelf, name: string, to: string | undefined): ShelfChange<LevelEntry> {
  const found = shelf.trash.find(({ trash }) => trash === name);
  if (found === undefined)
    throw new Refused(storageError('unknown-level', 'this level is not in the trash', 'it may have been restored already'));
  const id = to ?? found.id;
  mustBeFree(shelf, id);
  return changed(withLevel({ ...shelf, trash: shelf.trash.filter((entry) => entry !== found) }, id, found.text), id);
}

/** @param ids of all levels */
export function orderLevels(shelf: Shelf, ids: readonly string[]): ShelfChange<OrderResponse> {
  const all = [...shelf.levels.keys()];
  if (ids.length !== all.length || all.some((id) => !ids.includes(id))) {
    throw new Refused(storageError('list-changed', 'the levels have changed since this order was made', 'reload the list'));
  }
  const ordered = { ...shelf, levels: new Map(ids.map((id) => [id, mustExist(shelf, id)])) };
  const list = listOf(ordered);
  return { shelf: ordered, value: { renamed: [], levels: list.levels }, event: { type: 'list', list } };
}

/** @param text null: it is removed @param base etag of the version to replace; null: there is none */
export function writePack(shelf: Shelf, text: string | null, base: string | null): ShelfChange<PackOnDisk | null> {
  if ((packOf(shelf)?.etag ?? null) !== base)
    throw new Refused(
      storageError('conflict', 'pack.json has changed since it was read', 'it is read again; then do it once more'),
    );
  const reading = text === null ? null : readPack(text);
  if (reading?.ok === false) {
    const { problems } = reading;
    throw new Refused(storageError('invalid-pack', problems[0].message, problems[0].hint, { problems }));
  }
  const version = shelf.version + 1;
  const next = { ...shelf, version, pack: text === null ? null : { text, version } };
  const pack = packOf(next);
  return { shelf: next, value: pack, event: { type: 'pack', pack, by: null } };
}

function changed(shelf: Shelf, id: string): ShelfChange<LevelEntry> {
  const entry = entryOf(id, mustExist(shelf, id));
  return { shelf, value: entry, event: { type: 'changed', entry, by: null } };
}

function mustBeValid(text: string): void {
  const reading = readText(text);
  if (reading.ok) return;
  const problems = [...reading.problems];
  throw new Refused(storageError('invalid-level', problems[0].message, problems[0].hint, { problems }));
}
