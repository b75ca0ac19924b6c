import {
  type DeleteResponse,
  type EditEvent,
  type LevelEntry,
  type OrderResponse,
  type PackOnDisk,
  readPack,
  type TrashEntry,
} from '../../../schema/index.ts';
import { readText } from './disk-text.ts';
import { storageError } from './level-storage.ts';
import { entryOf, listOf, mustBeFree, mustExist, mustFit, packOf, Refused, type Shelf, withLevel, without } from './shelf.ts';

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
