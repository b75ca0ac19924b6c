import { join } from 'node:path';
import {
  type DeleteResponse,
  LEVEL_ID_PART,
  type LevelEntry,
  type OrderResponse,
  PACK_NAME,
  type PackResponse,
  type ReadResponse,
  type TrashResponse,
} from '../../schema/index.ts';
import { createFile, moveFile, replaceFile } from '../io/index.ts';
import { createKnownLevels, type KnownLevels } from './known-levels.ts';
import { findLevel, findLevels, findLike, hasFolder, joinId, type LevelFileFound, pathOfNew, splitId } from './level-files.ts';
import { oneAtATime } from './one-at-a-time.ts';
import { readPackOnDisk, writePackOnDisk } from './pack-on-disk.ts';
import { type Base, createEntryReader, type EntryReader, entryOf, etagOf } from './read-entry.ts';
import {
  alreadyThere,
  badName,
  nameTaken,
  Refusal,
  refusalOf,
  refuseInvalid,
  refuseReadOnly,
  refuseWayOut,
  unknownFolder,
  unknownLevel,
} from './refusal.ts';
import { moveAll, namesInOrder } from './reorder.ts';
import type { TermsOnDisk } from './terms-on-disk.ts';
import { collectLeftovers, findTrash, moveToTrash } from './trash.ts';

/**
 * The levels of one folder on the disk. Every call looks at the disk again. A change affects only the file that is named by an
 * existing id, and only if it still has the content that the client knows. Every method may throw a `Refusal`; then nothing
 * has changed.
 */
export interface LevelFolder {
  readonly known: KnownLevels;
  read(id: string): ReadResponse;
  /** Stores a text unchanged, if it is a valid level. */
  write(id: string, text: string, base: Base, client: string): Promise<{ entry: LevelEntry; created: boolean }>;
  rename(id: string, to: string, etag: string, client: string): Promise<LevelEntry>;
  duplicate(id: string, to: string, etag: string, client: string): Promise<LevelEntry>;
  /** Moves a level to the trash. */
  remove(id: string, etag: string, client: string): Promise<DeleteResponse>;
  trash(): TrashResponse;
  /** @param to its new id; by default its old one */
  restore(trash: string, to: string | undefined, client: string): Promise<LevelEntry>;
  /** Renames the files of one folder so that they sort as wanted. @param ids all ids of the folder, in the wanted order */
  order(folder: string, ids: readonly string[], client: string): Promise<OrderResponse>;
  /** Stores the text of `pack.json` unchanged, if it is valid; null removes the file. */
  writePack(text: string | null, base: Base, client: string): Promise<PackResponse>;
  /** Stops reading and cleaning up. */
  end(): void;
}

/** ms; an unfinished file older than this is no longer being written */
const ABANDONED_AFTER = 60_000;

/**
 * @param root the folder's real path
 * @param shown the folder as the user named it
 * @param termsNow reads the terms of the folder's configuration; by default there is none
 */
export const openLevelFolder = (root: string, shown: string, termsNow?: TermsOnDisk): LevelFolder =>
  new FolderOnDisk(root, shown, termsNow);

class FolderOnDisk implements LevelFolder {
  readonly known: KnownLevels;
  private readonly reader: EntryReader;
  private readonly again: NodeJS.Timeout;

  constructor(
    private readonly root: string,
    private readonly shown: string,
    termsNow?: TermsOnDisk,
  ) {
    this.reader = createEntryReader((id) => this.nameOf(id));
    this.known = createKnownLevels(root, shown, this.reader, termsNow);
    this.collect();
    // once more later, for files that were too young now; the process does not wait for this timer
    this.again = setTimeout(() => this.collect(), 2 * ABANDONED_AFTER).unref();
  }

  read(id: string): ReadResponse {
    return this.reader.read(this.find(id));
  }

  async write(id: string, text: string, base: Base, client: string): Promise<{ entry: LevelEntry; created: boolean }> {
    const { root, reader } = this;
    if (base === 'no-file') this.placeFor(id);
    const content = Buffer.from(text);
    refuseInvalid(content);
    return this.change([id], client, () => {
      const found = findLevel(root, id);
      // a repeated request: the answer to the first one was lost
      const isDone = found !== undefined && reader.read(found).etag === etagOf(content);
      if (isDone) return { entry: this.entryNow(id), created: false };
      if (base === 'no-file') {
        const current = () => (found === undefined ? null : reader.read(found));
        if (!createFile(this.placeFor(id), content)) throw alreadyThere(this.nameOf(id), current());
        return { entry: this.entryNow(id), created: true };
      }
      refuseReadOnly(this.onBase(id, base.etag));
      replaceFile(this.find(id).path, content, () => this.onBase(id, base.etag));
      return { entry: this.entryNow(id), created: false };
    });
  }

  rename(id: string, to: string, etag: string, client: string): Promise<LevelEntry> {
    return this.change([id, to], client, () => {
      const { path } = this.find(id);
      const target = this.placeFor(to, id);
      refuseReadOnly(this.onBase(id, etag));
      if (id !== to && !moveFile(path, target)) throw nameTaken(this.nameOf(to));
      return this.entryNow(to);
    });
  }

  duplicate(id: string, to: string, etag: string, client: string): Promise<LevelEntry> {
    return this.change([to], client, () => {
      this.find(id);
      const target = this.placeFor(to);
      const content = Buffer.from(this.onBase(id, etag).text ?? '');
      refuseInvalid(content);
      if (!createFile(target, content)) throw nameTaken(this.nameOf(to));
      return this.entryNow(to);
    });
  }

  remove(id: string, etag: string, client: string): Promise<DeleteResponse> {
    return this.change([id], client, () => {
      const found = this.find(id);
      refuseReadOnly(this.onBase(id, etag));
      return { trashed: moveToTrash(this.root, found, new Date()) };
    });
  }

  trash(): TrashResponse {
    return { trash: findTrash(this.root).map(({ entry }) => entry) };
  }

  async restore(trash: string, wanted: string | undefined, client: string): Promise<LevelEntry> {
    const found = findTrash(this.root).find(({ entry }) => entry.trash === trash);
    if (found === undefined) throw unknownLevel(trash, 'among the deleted levels');
    const to = wanted ?? found.entry.id;
    return this.change([to], client, () => {
      if (!moveFile(found.file.path, this.placeFor(to))) throw nameTaken(this.nameOf(to));
      return this.entryNow(to);
    });
  }

  async order(folder: string, ids: readonly string[], client: string): Promise<OrderResponse> {
    const { root, reader, known } = this;
    const names = namesInOrder(ids.map((id) => splitId(id).name));
    const renamed = ids.map((from, i) => ({ from, to: joinId(folder, names[i]) })).filter(({ from, to }) => from !== to);
    const touched = renamed.flatMap(({ from, to }) => [from, to]);
    await this.change(touched, client, () => {
      const { files } = findLevels(root);
      const there = [...files.keys()].filter((id) => splitId(id).folder === folder);
      const wanted = new Set(ids);
      if (there.length !== ids.length || wanted.size !== ids.length || !there.every((id) => wanted.has(id))) {
        const where = join(this.shown, folder);
        throw new Refusal('list-changed', `these are not the levels of ${where}`, 'Load the list again, then order it.');
      }
      for (const { from } of renamed) {
        const found = files.get(from) as LevelFileFound;
        refuseWayOut(found.path);
        refuseReadOnly(reader.read(found));
      }
      moveAll(root, renamed, (id) => this.nameOf(id));
    });
    return { renamed, levels: (await known.refresh()).levels };
  }

  async writePack(text: string | null, base: Base, client: string): Promise<PackResponse> {
    const { root, shown, known } = this;
    try {
      return await oneAtATime(root, () => {
        // what another program has changed is announced as its own
        known.refreshPack(null);
        writePackOnDisk(root, shown, text, base);
        known.refreshPack(client);
        return { pack: readPackOnDisk(root, shown) };
      });
    } catch (error) {
      throw refusalOf(error, join(shown, PACK_NAME));
    }
  }

  readonly end = (): void => {
    clearTimeout(this.again);
    this.known.end();
  };

  /** The path of a level as the user sees it. */
  private nameOf(id: string): string {
    return join(this.shown, `${id}.level.json`);
  }

  /** @throws Refusal if there is none */
  private find(id: string): LevelFileFound {
    const found = findLevel(this.root, id);
    if (found === undefined) throw unknownLevel(id, `in ${this.shown}`);
    refuseWayOut(found.path);
    return found;
  }

  private entryNow(id: string): LevelEntry {
    return entryOf(this.reader.read(this.find(id)));
  }

  /** The file as it is now. @throws Refusal if it does not have the content that the client knows */
  private onBase(id: string, etag: string): ReadResponse {
    const found = findLevel(this.root, id);
    const current = found === undefined ? null : this.reader.read(found);
    if (current?.etag === etag) return current;
    const what = current === null ? 'is no longer there' : 'has changed on the disk since the version that was edited';
    const hint = 'Combine your change with what is on the disk, then save again.';
    throw new Refusal('conflict', `${this.nameOf(id)} ${what}`, hint, { current });
  }

  /** The path for a new or renamed file. @param now its current id, if it is renamed @throws Refusal if it is not allowed */
  private placeFor(id: string, now: string | null = null): string {
    const { root } = this;
    const { folder, name } = splitId(id);
    if (!LEVEL_ID_PART.test(name)) throw badName(name);
    // an id has one spelling: /a is not a
    if (joinId(folder, name) !== id || !hasFolder(root, folder)) throw unknownFolder(folder, this.shown);
    // A and a are the same file on some systems, where a checkout keeps only one of them, by chance
    const twin = findLike(root, id).find((other) => other !== id && other !== now);
    if (twin !== undefined) throw nameTaken(this.nameOf(twin));
    const path = pathOfNew(root, folder, name);
    refuseWayOut(path);
    return path;
  }

  /** Makes a change while no other `gq edit` makes one, and announces its effect on these files. */
  private async change<T>(ids: readonly string[], client: string, work: () => T): Promise<T> {
    try {
      return await oneAtATime(this.root, () => {
        try {
          return work();
        } finally {
          this.known.announce(ids, client);
        }
      });
    } catch (error) {
      throw refusalOf(error, ids.length > 0 ? this.nameOf(ids[0]) : this.shown);
    }
  }

  private collect(): void {
    try {
      collectLeftovers(this.root, this.known.list().folders, new Date(), ABANDONED_AFTER);
    } catch {
      // if the folder can't be written, it contains nothing to clean up
    }
  }
}
