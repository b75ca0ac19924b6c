import { createStore, type StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import { type EditedLevel, levelText } from '../document/index.ts';
import { isQuota } from '../journal/index.ts';
import { type Base, fromStored, toStored, wholeIn, wholeText } from './stored-text.ts';
import { thin } from './thinning.ts';
import { checkOf, inTime, type Noted, type PastVersion, shortened, type Version, type VersionBy } from './version.ts';
import type { NewVersion, VersionStore, Waiting } from './version-store.ts';

/** The history of one level. */
export interface LevelVersions {
  /** The versions, oldest first; null until `load` was called. */
  readonly store: StoreApi<readonly Version[] | null>;
  /** This version is on disk. It is recorded when the page is idle; if the page is gone by then, by the next one. */
  note(file: LevelFile, by: VersionBy): void;
  /** Reads the list. @returns whether it could be read */
  load(): Promise<boolean>;
  /** The text of a version; null if it can't be read. */
  text(version: Version): Promise<string | null>;
  /** Records the present version if it is new, and gives it a name. @returns whether it is kept */
  nameNow(name: string): Promise<boolean>;
  /** Names a version anew; null: it has no name any more. @returns whether that is kept */
  rename(version: Version, name: string | null): Promise<boolean>;
  /**
   * Adds versions of a file, except those that are there.
   * @param versions each with the canonical text of a level
   * @returns how many were added; null: they can't be kept
   */
  import(versions: readonly PastVersion[]): Promise<number | null>;
  /** The level has another place from now on. */
  moveTo(place: string): void;
  /** Resolves when everything that was noted is recorded or could not be. */
  settled(): Promise<void>;
  /** Records what was noted, at once, and stops following. */
  close(): void;
}

export interface LevelVersionsParts {
  /** Where the history is kept at this moment. */
  readonly store: () => VersionStore;
  /** Acts after everything that was asked for before. */
  readonly inTurn: <T>(act: () => Promise<T>) => Promise<T>;
  /** ms since 1970 */
  readonly now: () => number;
  /** Calls back once the page is idle. @returns cancels it */
  readonly whenIdle: (call: () => void) => () => void;
  /** Called after each attempt to store something; null: it succeeded. */
  readonly onStored: (error: unknown) => void;
  readonly onClose: () => void;
}

/** Which part of a history stays if the database is full. */
const KEPT_PART = 0.5;

/** How many versions are recorded between two thinnings. */
const THIN_EVERY = 50;
/** The longest list of steps that are not on disk yet. */
const MOST_PENDING = 500;
/** The most labels of versions that can't be recorded. */
const MOST_LABELS = 50;

const DONE = [() => true, () => false] as const;

/** Follows a level: what reaches its disk is kept as a version. */
export class RecordedVersions implements LevelVersions {
  readonly store: StoreApi<readonly Version[] | null> = createStore<readonly Version[] | null>(() => null);
  /** Steps since the last version, and the file that each led to. */
  private steps: { readonly label: string; readonly file: LevelFile }[] = [];
  /** Noted versions that the store did not take, and the end of handing over the others. */
  private refused: Noted[] = [];
  private handed: Promise<unknown> = Promise.resolve();
  private base: Base | null = null;
  private added = 0;
  private cancel: (() => void) | null = null;
  /** The history in the store that it was opened in; its number once that is known. */
  private opened: { readonly in: VersionStore; readonly history: Promise<number>; number: number | null } | null = null;
  private last: Promise<unknown> = Promise.resolve();
  private readonly stop: () => void;

  /** @param place a name of the level in its folder */
  constructor(
    private place: string,
    private readonly level: EditedLevel,
    private readonly parts: LevelVersionsParts,
  ) {
    this.stop = level.onStep(({ kind, label, file }) => {
      this.steps.push({ label: kind === 'undo' ? `Undo: ${label}` : kind === 'redo' ? `Redo: ${label}` : label, file });
      if (this.steps.length > MOST_PENDING) this.steps.shift();
    });
    void this.inTurn(async () => {});
  }

  note(file: LevelFile, by: VersionBy): void {
    const index = this.steps.findLastIndex((step) => step.file === file);
    const labels = this.steps.splice(0, index + 1).map(({ label }) => label);
    const noted = { text: levelText(file), by, labels, time: this.parts.now() };
    const store = this.parts.store();
    const number = this.opened?.in === store ? this.opened.number : null;
    // at once: the page may be gone the next moment
    const handing =
      number === null
        ? this.inTurn((there, history) => there.handOver(history, noted))
        : store.handOver(number, noted).then(...DONE);
    const taken = handing.then((isDone) => isDone || this.refused.push(noted));
    this.handed = Promise.all([this.handed, taken]).then(() => {});
    this.cancel ??= this.parts.whenIdle(() => void this.record(false));
  }

  async load(): Promise<boolean> {
    await this.record();
    return this.inTurn(async (store, history) => {
      this.store.setState(inTime(await store.list(history)), true);
    });
  }

  async text(version: Version): Promise<string | null> {
    let text: string | null = null;
    await this.inTurn(async (store, history) => {
      const { copies, bases } = await store.texts(history, version);
      text = fromStored(copies, bases, version.check);
    });
    return text;
  }

  async nameNow(name: string): Promise<boolean> {
    this.note(this.level.committedFile(), 'page');
    await this.record();
    const text = levelText(this.level.committedFile());
    let isKept = false;
    const isDone = await this.inTurn(async (store, history) => {
      const last = await store.last(history);
      if (last?.check !== checkOf(text)) return;
      await store.change(history, [], [{ ...last, name }]);
      isKept = true;
    });
    await this.reload();
    return isDone && isKept;
  }

  async rename({ number }: Version, name: string | null): Promise<boolean> {
    const isDone = await this.inTurn(async (store, history) => {
      // its labels may have changed since it was read
      const now = (await store.list(history)).find((version) => version.number === number);
      if (now !== undefined) await store.change(history, [], [{ ...now, name }]);
    });
    await this.reload();
    return isDone;
  }

  async import(versions: readonly PastVersion[]): Promise<number | null> {
    await this.record();
    let added = 0;
    const isDone = await this.inTurn(async (store, history) => {
      const known = new Set((await store.list(history)).map(({ check, time }) => `${check} ${time}`));
      for (const { text, name, time, by, labels, more, changes } of versions) {
        const version: NewVersion = { time, by, ...shortened(labels, more), changes, name, check: checkOf(text) };
        if (known.has(`${version.check} ${time}`)) continue;
        const last = await store.last(history);
        const stored = await this.put(store, history, version, text);
        if (stored !== null && stored.number !== last?.number) added++;
        known.add(`${version.check} ${time}`);
      }
    });
    await this.reload();
    return isDone ? added : null;
  }

  moveTo(place: string): void {
    this.place = place;
  }

  async settled(): Promise<void> {
    await this.record();
    await this.last;
  }

  close(): void {
    this.stop();
    void this.record();
    this.parts.onClose();
  }

  /** Records what was noted, by this page or one that is gone. @param isAsked whether someone waits for it */
  private async record(isAsked = true): Promise<boolean> {
    this.cancel?.();
    this.cancel = null;
    // not what is handed over in a later turn
    const { handed } = this;
    const isDone = await this.inTurn(async (store, history) => {
      await handed;
      const words = await import('./changes-in-short.ts').catch(() => null);
      // a page that goes away loads nothing more; what waits can be told by the next one
      if (words === null && !isAsked) return;
      for (const waiting of await store.waiting(history)) await this.add(store, history, waiting, words, waiting);
      for (; this.refused.length > 0; this.refused.shift()) await this.add(store, history, this.refused[0], words);
    });
    // The next attempt comes with the next version. Those between are lost, but not what they were called.
    const last = this.refused.at(-1);
    if (!isDone && last !== undefined)
      this.refused = [{ ...last, labels: this.refused.flatMap(({ labels }) => labels).slice(-MOST_LABELS) }];
    return isDone;
  }

  /** @param words null: they can't be loaded; @param waiting where it waits in the store */
  private async add(
    store: VersionStore,
    history: number,
    { by, labels, time, text }: Noted,
    words: typeof import('./changes-in-short.ts') | null,
    waiting: Waiting | null = null,
  ): Promise<void> {
    const check = checkOf(text);
    const before = await store.last(history);
    if (before?.check === check) {
      if (waiting !== null) await store.forget(waiting);
      return;
    }
    let changes = '';
    if (before !== null) {
      this.base ??= await baseOf(store, history, before);
      const { copies, bases } = await store.texts(history, before);
      changes = words?.changesInShort(fromStored(copies, bases, before.check) ?? text, text) ?? '';
    }
    const version: NewVersion = { time, by, ...shortened(labels), changes, name: null, check };
    const added = await this.put(store, history, version, text, waiting);
    if (added === null || added.number === before?.number) return;
    const listed = this.store.getState();
    if (listed !== null) this.store.setState(inTime([...listed, added]), true);
    if (++this.added % THIN_EVERY === 1) await this.thinOut(store, history);
  }

  /** Stores a version; room is made if the database is full. */
  private async put(
    store: VersionStore,
    history: number,
    version: NewVersion,
    text: string,
    waiting: Waiting | null = null,
  ): Promise<Version | null> {
    const put = async () =>
      // another page may have thinned out what it is stored by
      (await store.add(history, version, toStored(text, this.base), waiting)) ??
      (await store.add(history, version, wholeText(text), waiting));
    const added = await put().catch(async (error) => {
      if (!isQuota(error)) throw error;
      await this.thinOut(store, history, KEPT_PART);
      return put();
    });
    if (added?.base === added?.number && added !== null) this.base = { number: added.number, text, uses: 1 };
    else if (this.base !== null) this.base = { ...this.base, uses: this.base.uses + 1 };
    return added;
  }

  /** @param part of what is stored may stay */
  private async thinOut(store: VersionStore, history: number, part = 1): Promise<void> {
    const versions = inTime(await store.list(history));
    const size = versions.reduce((sum, version) => sum + version.size, 0);
    const limits = part < 1 ? { versions: part * versions.length, size: part * size } : undefined;
    const { drop, put } = thin(versions, this.parts.now(), limits);
    if (drop.length === 0) return;
    await store.change(history, drop, put);
    if (this.store.getState() !== null) this.store.setState(inTime(await store.list(history)), true);
  }

  private async reload(): Promise<void> {
    if (this.store.getState() !== null) await this.load();
  }

  /** @returns whether it succeeded */
  private inTurn(act: (store: VersionStore, history: number) => Promise<void>): Promise<boolean> {
    // the level may have another place by the time it is its turn
    const { place } = this;
    const turn = this.parts.inTurn(async () => {
      const store = this.parts.store();
      try {
        if (this.opened?.in !== store) {
          this.base = null;
          const opened = { in: store, history: store.open(place), number: null as number | null };
          this.opened = opened;
          opened.number = await opened.history;
        }
        await act(store, await this.opened.history);
        this.parts.onStored(null);
        return true;
      } catch (error) {
        this.opened = null;
        this.base = null;
        this.parts.onStored(error);
        return false;
      }
    });
    this.last = turn;
    return turn;
  }
}

/** The whole text by which a version is stored, for those that follow; null if it is damaged. */
async function baseOf(store: VersionStore, history: number, version: Version): Promise<Base | null> {
  const { number, base } = version;
  const text = wholeIn((await store.texts(history, version)).bases);
  return text === null ? null : { number: base, text, uses: 1 + number - base };
}
