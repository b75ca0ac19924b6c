import { createHash } from 'node:crypto';
import { setImmediate } from 'node:timers/promises';
import type { EditEvent, FolderRules, LevelEntry, ListResponse } from '../../schema/index.ts';
import { systemReason } from '../failure.ts';
import { schemaReference } from '../schema-reference.ts';
import { changesBetween } from './changes.ts';
import { findLevel, findLevels, type LevelFileFound } from './level-files.ts';
import type { EntryReader } from './read-entry.ts';
import { NO_CONFIG, type RulesOnDisk } from './rules-on-disk.ts';
import { SortedEntries } from './sorted-entries.ts';

/** What has been reported of a folder to everybody, kept the same as the disk. */
export interface KnownLevels {
  /** What is known now. */
  list(): ListResponse;
  /** Looks at the whole folder and announces what other programs have changed. @returns the list as it is then; what is known while it is read for the first time */
  refresh(): Promise<ListResponse>;
  /** Looks at the configuration and announces it where it is another one. */
  refreshRules(): void;
  /** Looks at some files alone and announces what `by` has done to them; null: another program. */
  announce(ids: readonly string[], by: string | null): void;
  /** Reports what goes on from now on. @returns how to end it */
  listen(listener: (event: EditEvent) => void): () => void;
  /** Something about the folder that a person should know from now on. */
  addTrouble(message: string): void;
  /** Reads no further. */
  end(): void;
}

/** So many files are read before anybody asks; of larger folders the rest is reported as it is read. */
const READ_AT_ONCE = 500;

/** Levels that are reported together while a folder is read for the first time. */
const REPORTED_TOGETHER = 1000;

/** How long the disk is read before others get their turn, ms. */
const SLICE = 20;

/** Of more files than this the whole folder is looked at. */
const FEW = 20;

/**
 * Reads a folder and keeps up with it.
 * @param shown the folder as a person named it
 * @param rulesNow what its configuration sets; nothing when left out
 */
export const createKnownLevels = (
  root: string,
  shown: string,
  reader: EntryReader,
  rulesNow: RulesOnDisk = () => NO_CONFIG,
): KnownLevels => new FolderReports(root, shown, reader, rulesNow);

class FolderReports implements KnownLevels {
  private readonly listeners = new Set<(event: EditEvent) => void>();
  private readonly troubles: string[] = [];
  private readonly folder: ListResponse['folder'];
  private readonly levels: SortedEntries;
  private folders: readonly string[];
  private rules: FolderRules;
  /** Of the last look. */
  private lookTroubles: readonly string[];
  /** Files of a large folder that are still to be read for the first time. */
  private unread: number;
  private isOver = false;
  /** Ids that were announced during a look at the whole folder, which may have seen them before that. */
  private announced = new Set<string>();
  /** The look that goes on, and the one after it. */
  private current: Promise<void> = Promise.resolve();
  private next: Promise<void> | null = null;

  constructor(
    private readonly root: string,
    shown: string,
    private readonly reader: EntryReader,
    private readonly rulesNow: RulesOnDisk,
  ) {
    const id = createHash('sha256').update(root).digest('hex').slice(0, 16);
    this.folder = { id, path: shown, $schema: schemaReference(root) };
    const { files: found, folders, troubles } = findLevels(root);
    const files = [...found.values()];
    this.folders = folders;
    this.rules = rulesNow();
    this.lookTroubles = troubles;
    this.levels = new SortedEntries(files.slice(0, READ_AT_ONCE).map((file) => reader.entry(file)));
    this.unread = files.length - this.levels.all.length;
    if (this.unread === 0) return;
    setImmediate()
      .then(() => this.readRest(files.slice(READ_AT_ONCE)))
      .catch((error) => this.addTrouble(`the folder could not be read completely: ${systemReason(error)}`));
  }

  list(): ListResponse {
    const { folder, folders, levels, rules, troubles, lookTroubles, unread } = this;
    return { folder, folders: [...folders], levels: [...levels.all], rules, troubles: [...troubles, ...lookTroubles], unread };
  }

  // who asks while a look goes on gets the next one, which begins after the question
  async refresh(): Promise<ListResponse> {
    this.refreshRules();
    this.next ??= this.current.then(() => {
      this.next = null;
      const look = this.lookAtAll();
      // one that fails is its asker's business, and not that of the next
      this.current = look.catch(() => {});
      return look;
    });
    await this.next;
    return this.list();
  }

  refreshRules(): void {
    const rules = this.rulesNow();
    if (JSON.stringify(rules) === JSON.stringify(this.rules)) return;
    this.rules = rules;
    this.report({ type: 'rules', rules });
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
        // who can't hear any more is nobody else's business, least of all of who has just written
        this.listeners.delete(listener);
      }
    }
  }

  /** Reads what is left of a large folder, bit by bit. */
  private async readRest(rest: readonly LevelFileFound[]): Promise<void> {
    const { levels, reader } = this;
    let together: LevelEntry[] = [];
    let since = performance.now();
    for (const [i, file] of rest.entries()) {
      if (this.isOver) return;
      together.push(reader.entry(file));
      if (together.length >= REPORTED_TOGETHER || i === rest.length - 1) {
        // one that was made or changed meanwhile is known already
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
