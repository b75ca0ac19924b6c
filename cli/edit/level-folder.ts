import { realpathSync } from 'node:fs';
import { dirname, join } from 'node:path';
import {
  type DeleteResponse,
  LEVEL_ID_PART,
  type LevelEntry,
  type OrderResponse,
  type ReadResponse,
  readLevel,
  type TrashResponse,
} from '../../schema/index.ts';
import { createFile, isTaken, moveFile, replaceFile } from '../disk.ts';
import { createKnownLevels, type KnownLevels } from './known-levels.ts';
import { collectLeftovers } from './leftovers.ts';
import { findLevel, findLevels, findLike, hasFolder, joinId, type LevelFileFound, pathOfNew, splitId } from './level-files.ts';
import { oneAtATime } from './one-at-a-time.ts';
import { createEntryReader, entryOf, etagOf } from './read-entry.ts';
import { Refusal, refusalOf } from './refusal.ts';
import { inSafeOrder, type Move, namesInOrder } from './reorder.ts';
import { findTrash, moveToTrash } from './trash.ts';

/** What a change rests on: the etag of the content that was seen, or that there was no such file. */
export type Base = { readonly etag: string } | 'no-file';

/**
 * The levels of one folder on the disk. Every question looks at the disk anew; nothing is changed but what was named, by an id
 * that is there, with the content it was seen with. What is refused has changed nothing: every method may throw a `Refusal`.
 */
export interface LevelFolder {
  readonly known: KnownLevels;
  read(id: string): ReadResponse;
  /** Stores a text as it is, when it is a valid level. */
  write(id: string, text: string, base: Base, client: string): Promise<{ entry: LevelEntry; created: boolean }>;
  rename(id: string, to: string, etag: string, client: string): Promise<LevelEntry>;
  duplicate(id: string, to: string, etag: string, client: string): Promise<LevelEntry>;
  /** Moves it to the trash. */
  remove(id: string, etag: string, client: string): Promise<DeleteResponse>;
  trash(): TrashResponse;
  /** @param to where it goes; its old id when undefined */
  restore(trash: string, to: string | undefined, client: string): Promise<LevelEntry>;
  /** Renames the files of one folder so that they sort as wanted; `ids` must be all there are. */
  order(folder: string, ids: readonly string[], client: string): Promise<OrderResponse>;
  /** Nothing is read or cleaned up from now on. */
  end(): void;
}

/** ms: an unfinished file that old is no longer being written */
const ABANDONED_AFTER = 60_000;

/**
 * @param root the folder's real path
 * @param shown the folder as a person named it
 */
export function openLevelFolder(root: string, shown: string): LevelFolder {
  const nameOf = (id: string): string => join(shown, `${id}.level.json`);
  const reader = createEntryReader(nameOf);
  const known = createKnownLevels(root, shown, reader);

  const find = (id: string): LevelFileFound | undefined => findLevel(root, id);
  const findOrRefuse = (id: string): LevelFileFound => {
    const found = find(id);
    if (found === undefined) throw unknownLevel(id, `in ${shown}`);
    refuseWayOut(found.path);
    return found;
  };

  /** The file as it is, when that is the content it was seen with. */
  const onBase = (id: string, etag: string): ReadResponse => {
    const found = find(id);
    const current = found === undefined ? null : reader.read(found);
    if (current?.etag === etag) return current;
    const what = current === null ? 'is no longer there' : 'is another one on the disk than the change was made from';
    const hint = 'Put the change and what is on the disk together, then save again.';
    throw new Refusal('conflict', `${nameOf(id)} ${what}`, hint, { current });
  };

  /** Where a new file may stand, or one that is called otherwise now. */
  const placeFor = (id: string, now: string | null = null): string => {
    const { folder, name } = splitId(id);
    if (!LEVEL_ID_PART.test(name)) throw badName(name);
    // an id is written in one way: /a is not a
    if (joinId(folder, name) !== id || !hasFolder(root, folder)) throw unknownFolder(folder, shown);
    // A and a are one file on some systems, and which of the two a checkout leaves there is chance
    const twin = findLike(root, id).find((other) => other !== id && other !== now);
    if (twin !== undefined) throw nameTaken(nameOf(twin));
    const path = pathOfNew(root, folder, name);
    refuseWayOut(path);
    return path;
  };

  const entryNow = (id: string): LevelEntry => entryOf(reader.read(findOrRefuse(id)));

  /** Does a change while nobody else does one, and tells everybody of what it did to these files. */
  const change = async <T>(ids: readonly string[], client: string, work: () => T): Promise<T> => {
    try {
      return await oneAtATime(root, () => {
        try {
          return work();
        } finally {
          known.announce(ids, client);
        }
      });
    } catch (error) {
      throw refusalOf(error, ids.length > 0 ? nameOf(ids[0]) : shown);
    }
  };

  const write: LevelFolder['write'] = async (id, text, base, client) => {
    if (base === 'no-file') placeFor(id);
    const content = Buffer.from(text);
    refuseInvalid(content);
    return change([id], client, () => {
      const found = find(id);
      // the same again: the answer to the last time was lost
      const isDone = found !== undefined && reader.read(found).etag === etagOf(content);
      if (isDone) return { entry: entryNow(id), created: false };
      if (base === 'no-file') {
        if (!createFile(placeFor(id), content)) throw alreadyThere(nameOf(id), found === undefined ? null : reader.read(found));
        return { entry: entryNow(id), created: true };
      }
      refuseReadOnly(onBase(id, base.etag));
      replaceFile(findOrRefuse(id).path, content, () => onBase(id, base.etag));
      return { entry: entryNow(id), created: false };
    });
  };

  const rename: LevelFolder['rename'] = (id, to, etag, client) =>
    change([id, to], client, () => {
      const { path } = findOrRefuse(id);
      const target = placeFor(to, id);
      refuseReadOnly(onBase(id, etag));
      if (id !== to && !moveFile(path, target)) throw nameTaken(nameOf(to));
      return entryNow(to);
    });

  const duplicate: LevelFolder['duplicate'] = (id, to, etag, client) =>
    change([to], client, () => {
      findOrRefuse(id);
      const target = placeFor(to);
      const content = Buffer.from(onBase(id, etag).text ?? '');
      refuseInvalid(content);
      if (!createFile(target, content)) throw nameTaken(nameOf(to));
      return entryNow(to);
    });

  const remove: LevelFolder['remove'] = (id, etag, client) =>
    change([id], client, () => {
      const found = findOrRefuse(id);
      refuseReadOnly(onBase(id, etag));
      return { trashed: moveToTrash(root, found, new Date()) };
    });

  const restore: LevelFolder['restore'] = async (trash, wanted, client) => {
    const found = findTrash(root).find(({ entry }) => entry.trash === trash);
    if (found === undefined) throw unknownLevel(trash, 'among the deleted ones');
    const to = wanted ?? found.entry.id;
    return change([to], client, () => {
      if (!moveFile(found.file.path, placeFor(to))) throw nameTaken(nameOf(to));
      return entryNow(to);
    });
  };

  const order: LevelFolder['order'] = async (folder, ids, client) => {
    const names = namesInOrder(ids.map((id) => splitId(id).name));
    const renamed = ids.map((from, i) => ({ from, to: joinId(folder, names[i]) })).filter(({ from, to }) => from !== to);
    const touched = renamed.flatMap(({ from, to }) => [from, to]);
    await change(touched, client, () => {
      const { files } = findLevels(root);
      const there = [...files.keys()].filter((id) => splitId(id).folder === folder);
      const wanted = new Set(ids);
      if (there.length !== ids.length || wanted.size !== ids.length || !there.every((id) => wanted.has(id))) {
        throw new Refusal('list-changed', `these are not the levels of ${join(shown, folder)}`, 'Load the list, then order it.');
      }
      for (const { from } of renamed) {
        const found = files.get(from) as LevelFileFound;
        refuseWayOut(found.path);
        refuseReadOnly(reader.read(found));
      }
      moveAll(renamed);
    });
    return { renamed, levels: (await known.refresh()).levels };
  };

  /** Every move or none. */
  const moveAll = (moves: readonly Move[]): void => {
    const pathIn = (id: string): string => pathOfNew(root, '', id);
    const aside = (id: string): string => {
      for (let n = 1; ; n++) if (!isTaken(pathIn(`${id}-moved-${n}`))) return `${id}-moved-${n}`;
    };
    const done: Move[] = [];
    try {
      for (const move of inSafeOrder(moves, aside)) {
        if (!moveFile(pathIn(move.from), pathIn(move.to))) throw nameTaken(nameOf(move.to));
        done.push(move);
      }
    } catch (error) {
      for (const { from, to } of done.reverse()) moveFile(pathIn(to), pathIn(from));
      throw error;
    }
  };

  const collect = (): void => {
    try {
      collectLeftovers(root, known.list().folders, new Date(), ABANDONED_AFTER);
    } catch {
      // a folder that can't be written: nothing of ours is in it
    }
  };
  collect();
  // what was left just now, too; nothing waits for that
  const again = setTimeout(collect, 2 * ABANDONED_AFTER).unref();
  const end = (): void => {
    clearTimeout(again);
    known.end();
  };

  return {
    known,
    end,
    read: (id) => reader.read(findOrRefuse(id)),
    write,
    rename,
    duplicate,
    remove,
    trash: () => ({ trash: findTrash(root).map(({ entry }) => entry) }),
    restore,
    order,
  };
}

/** Refuses a path whose folder is reached through a link, or has become one: it may be anywhere. */
function refuseWayOut(path: string): void {
  const folder = dirname(path);
  try {
    if (realpathSync(folder) === folder) return;
  } catch (error) {
    throw refusalOf(error, path);
  }
  throw new Refusal(
    'unknown-folder',
    `${folder} is now reached through a link, which the editor doesn't follow`,
    'Start gq edit anew.',
  );
}

function refuseInvalid(content: Uint8Array): void {
  const read = readLevel(content);
  if (read.ok) return;
  const { problems } = read;
  const many = problems.length === 1 ? 'a problem' : `${problems.length} problems`;
  const message = `the text is not a valid level: it has ${many}`;
  throw new Refusal('invalid-level', message, 'Fix what the problems say, then save again; the file is as it was.', { problems });
}

function refuseReadOnly({ file, readOnly }: LevelEntry): void {
  if (readOnly === null) return;
  throw new Refusal('not-writable', `${file}: ${readOnly}`, 'Allow writing to it, or save under another name.');
}

function badName(name: string): Refusal {
  const hint = 'Use up to 80 letters a-z, digits, spaces, _ and -, beginning with a letter or digit, without .level.json.';
  return new Refusal('bad-name', `${quoted(name)} can't be the name of a level file on every system`, hint);
}

const unknownLevel = (id: string, where: string): Refusal =>
  new Refusal('unknown-level', `there is no level ${quoted(id)} ${where}`, 'Was it renamed or removed? Load the list again.');

const unknownFolder = (folder: string, shown: string): Refusal =>
  new Refusal(
    'unknown-folder',
    `there is no folder ${quoted(folder)} in ${shown}`,
    'Make the folder first, or take another one.',
  );

const nameTaken = (file: string): Refusal =>
  new Refusal('name-taken', `there is already something named ${file}`, 'Take another name.');

const alreadyThere = (file: string, current: ReadResponse | null): Refusal =>
  current === null
    ? nameTaken(file)
    : new Refusal('conflict', `${file} is already there`, 'Take another name, or open the level that is there.', { current });

/** A text from outside, short enough for a message. */
function quoted(text: string): string {
  return JSON.stringify(text.length > 80 ? `${text.slice(0, 80)}…` : text);
}
