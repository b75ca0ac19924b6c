import { createHash } from 'node:crypto';
import { setImmediate } from 'node:timers/promises';
import type { EditEvent, FolderTerms, LevelEntry, ListResponse, PackOnDisk } from '../../schema/index.ts';
import { schemaReference } from '../levels/index.ts';
import { systemReason } from '../terminal/index.ts';
import { changesBetween, SortedEntries } from './changes.ts';
import { findLevel, findLevels, type LevelFileFound } from './level-files.ts';
import { readPackOnDisk } from './pack-on-disk.ts';
import type { EntryReader } from './read-entry.ts';
import { NO_CONFIG, type TermsOnDisk } from './terms-on-disk.ts';

/** The state of a folder as reported to all listeners, kept up to date with the disk. */
export interface KnownLevels {
  /** The current state. */
  list(): ListResponse;
  /**
   * Reads the whole folder again and announces the changes of other programs. @returns the new list; during the first reading
   * of the folder, the list so far
   */
  refresh(): Promise<ListResponse>;
  /** Reads the configuration again and announces the terms if they have changed. */
  refreshTerms(): void;
  /** Reads `pack.json` again and announces it if it has changed. @param by the client that changed it; null: another program */
  refreshPack(by: string | null): void;
  /** Reads only these files again and announces their changes. @param by the client that made them; null: another program */
  announce(ids: readonly string[], by: string | null): void;
  /** Reports events from now on. @returns a function that stops it */
  listen(listener: (event: EditEvent) => void): () => void;
  /** Adds a message about the folder that the user should see from now on. */
  addTrouble(message: string): void;
  /** Stops reading. */
  end(): void;
}

/** The number of files that are read at once; in larger folders, the rest is read later and reported bit by bit. */
const READ_AT_ONCE = 500;

/** The number of levels in one report during the first reading of a folder. */
const REPORTED_TOGETHER = 1000;

/** ms of reading before the event loop gets a turn */
const SLICE = 20;

/** For more files than this, the whole folder is listed. */
const FEW = 20;

/**
 * Reads a folder and follows its changes.
 * @param shown the folder as the user named it
 * @param termsNow reads the terms of the folder's configuration; by default there is none
 */
export const createKnownLevels = (
  root: string,
  shown: string,
  reader: EntryReader,
  termsNow: TermsOnDisk = () => NO_CONFIG,
): KnownLevels => new FolderReports(root, shown, reader, termsNow);

class FolderReports implements KnownLevels {
  private readonly listeners = new Set<(event: EditEvent) => void>();
  private readonly troubles: string[] = [];
  private readonly folder: ListResponse['folder'];
  private readonly levels: SortedEntries;
  private folders: readonly string[];
  private terms: FolderTerms;
  private pack: PackOnDisk | null;
  /** The folders that could not be read the last time. */
  private lookTroubles: readonly string[];
  /** The number of files that have not been read yet. */
  private unread: number;
  private isOver = false;
  /** Ids that were announced while the whole folder was being read, which may have read them before the change. */
  private announced = new Set<string>();
  /** The refresh in progress, and the one after it. */
  private current: Promise<void> = Promise.resolve();
  private next: Promise<void> | null = null;

  constructor(
    private readonly root: string,
    private readonly shown: string,
    private readonly reader: EntryReader,
    private readonly termsNow: TermsOnDisk,
  ) {
    const id = createHash('sha256').update(root).digest('hex').slice(0, 16);
    this.folder = { id, path: shown, $schema: schemaReference(root) };
    const { files: found, folders, troubles } = findLevels(root);
    const files = [...found.values()];
    this.folders = folders;
    this.terms = termsNow();
    this.pack = readPackOnDisk(root, shown);
    this.lookTroubles = troubles;
    this.levels = new SortedEntries(files.slice(0, READ_AT_ONCE).map((file) => reader.entry(file)));
    this.unread = files.length - this.levels.all.length;
    if (this.unread === 0) return;
    setImmediate()
      .then(() => this.readRest(files.slice(READ_AT_ONCE)))
      .catch((error) => this.addTrouble(`the folder could not be read completely: ${systemReason(error)}`));
  }

  list(): ListResponse {
    const { folder, folders, levels, pack, terms, troubles, lookTroubles, unread } = this;
    return {
      folder,
      folders: [...folders],
      levels: [...levels.all],
      ...(pack !== null && { pack }),
      terms,
      troubles: [...troubles, ...lookTroubles],
      unread,
    };
  }

  // a call during a refresh gets the next refresh, which begins after the call
  async refresh(): Promise<ListResponse> {
    this.refreshTerms();
    this.refreshPack(null);
    this.next ??= this.current.then(() => {
      this.next = null;
      const look = this.lookAtAll();
      // a failure concerns the callers of this refresh, not those of the next one
      this.current = look.catch(() => {});
      return look;
    });
    await this.next;
    return this.list();
  }

  refreshTerms(): void {
    const terms = this.termsNow();
    if (JSON.stringify(terms) === JSON.stringify(this.terms)) return;
    this.terms = terms;
    this.report({ type: 'terms', terms });
  }

  refreshPack(by: string | null): void {
    const pack = readPackOnDisk(this.root, this.shown);
    if (JSON.stringify(pack) === JSON.stringify(this.pack)) return;
    this.pack = pack;
    this.report({ type: 'pack', pack, by });
  }

  announce(ids: readonly string[], by: string | null): void {
    const { root, reader, levels } = this;
    const all = ids.length > FEW ? findLevels(root).files : null;
    const before: LevelEntry[] = [];
    const after: LevelEntry[] = [];
    for (const id of new Set(ids)) {
      this.announced.add(id);
      const old = levels.get(id);
      if (old !== undefined) before.push(old);
      const file = all === null ? findLevel(root, id) : all.get(id);
      const entry = file === undefined ? undefined : reader.entry(file);
      if (entry === undefined) levels.remove(id);
      else {
        after.push(entry);
        levels.put(entry);
      }
    }
    const rest = this.list();
    for (const event of changesBetween({ ...rest, levels: before }, { ...rest, levels: after }, by)) this.report(event);
  }

  listen(listener: (event: EditEvent) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  addTrouble(message: string): void {
    if (this.troubles.includes(message)) return;
    this.troubles.push(message);
    this.report({ type: 'list', list: this.list() });
  }

  end(): void {
    this.isOver = true;
  }

  private report(event: EditEvent): void {
    for (const listener of this.listeners) {
      try {
        listener(event);
      } catch {
        // a broken listener must not disturb the others, nor the request whose change is reported
        this.listeners.delete(listener);
      }
    }
  }

  /** Reads the rest of a large folder, bit by bit. */
  private async readRest(rest: readonly LevelFileFound[]): Promise<void> {
    const { levels, reader } = this;
    let together: LevelEntry[] = [];
    let since = performance.now();
    for (const [i, file] of rest.entries()) {
      if (this.isOver) return;
      together.push(reader.entry(file));
      if (together.length >= REPORTED_TOGETHER || i === rest.length - 1) {
        // levels that were created or changed in the meantime are already known
        const news = together.filter(({ id }) => levels.get(id) === undefined);
        for (const entry of news) levels.put(entry);
        this.unread = rest.length - 1 - i;
        this.report({ type: 'read', levels: news, unread: this.unread });
        together = [];
      }
      if (performance.now() - since < SLICE) continue;
      await setImmediate();
      since = performance.now();
    }
    await this.refresh();
  }

  private async lookAtAll(): Promise<void> {
    if (this.unread > 0 || this.isOver) return;
    this.announced = new Set();
    const { levels, reader, announced } = this;
    const found = findLevels(this.root);
    const seen: LevelEntry[] = [];
    let since = performance.now();
    for (const file of found.files.values()) {
      seen.push(reader.entry(file));
      if (performance.now() - since < SLICE) continue;
      await setImmediate();
      since = performance.now();
    }
    const before = this.list();
    levels.replace(announced.size === 0 ? seen : seen.filter(({ id }) => !announced.has(id)));
    if (announced.size > 0) for (const entry of before.levels) if (announced.has(entry.id)) levels.put(entry);
    reader.keepOnly(levels.all);
    this.folders = found.folders;
    this.lookTroubles = found.troubles;
    for (const event of changesBetween(before, this.list(), null)) this.report(event);
  }
}
