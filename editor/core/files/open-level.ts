import { createStore, type StoreApi } from 'zustand/vanilla';
import { mergeLevels } from '../../../review/index.ts';
import { isSame, type Problem } from '../../../schema/index.ts';
import { createEditedLevel, type EditedLevel, levelText } from '../document/index.ts';
import type { Journal, Keeping, LevelJournal, Recovery } from '../journal/index.ts';
import type { LevelVersions, VersionKeeper } from '../versions/index.ts';
import type { DiskBase } from './known-disk.ts';
import type { LevelStorage, StorageError } from './level-storage.ts';
import { readStored } from './read-text.ts';
import { createSaver, type Saver } from './saver.ts';
import { type Throttled, type Timers, throttled } from './timers.ts';
import { WriterFollower } from './writer-follower.ts';
import { type Channel, claimLevel, type Role, type Shown, type WriterLock } from './writer-lock.ts';

/** What the page provides, and tests replace. */
export interface Surroundings {
  readonly storage: LevelStorage;
  readonly journal: Journal;
  readonly versions: VersionKeeper;
  readonly timers: Timers;
  /** The id of the folder, the same on every start: `folder.id` of its list. */
  readonly folder: string;
  readonly locks: Pick<LockManager, 'request'> | null;
  /** A channel by name between the pages of this browser; null if there is none. */
  readonly channel: (name: string) => Channel | null;
}

/** An open level: edited, kept in the journal, saved. */
export interface OpenedLevel {
  /** Changes when the level is renamed. */
  id(): string;
  readonly level: EditedLevel;
  readonly saver: Saver;
  readonly lock: WriterLock;
  /** Whether this page has changed a level that another page writes: the changes wait for the user to take over or drop them. */
  readonly holding: StoreApi<boolean>;
  /** Drops these changes, as a step that can be undone. */
  dropHeld(): void;
  /** The level as it leaves this page, to go on from there when it is opened again. */
  remember(): Remembered;
  /** Whether unsaved changes would outlive this page; null: this page keeps no journal of the level, as another page does. */
  readonly keeping: StoreApi<Keeping | null>;
  /** The versions of the level that were on disk, or have names. */
  readonly versions: LevelVersions;
  /** Unsaved changes of an earlier page. They are in the level again, as a step that can be undone. */
  readonly recovered: Recovery | null;
  /** Called when the level was renamed. */
  moved(id: string, etag: string): void;
  /** Saves the changes and releases the level. Changes that could not be saved stay in the journal. */
  close(): Promise<void>;
}

/** A level as a page last had it open. */
export interface Remembered {
  readonly level: EditedLevel;
  /** What its changes are based on that the page could only hold; null: there are none. */
  readonly held: DiskBase | null;
}

export type Opening =
  | { readonly ok: true; readonly opened: OpenedLevel }
  /** Not a level: it can be viewed and edited as text. */
  | {
      readonly ok: false;
      readonly kind: 'invalid';
      readonly text: string;
      readonly etag: string | null;
      readonly problems: readonly Problem[];
    }
  | { readonly ok: false; readonly kind: 'failed'; readonly error: StorageError };

/** The name under which this browser keeps what belongs to a level. */
export const placeOf = (folder: string, id: string): string => `${folder}/${id}`;

/** ms after which the journal is asked again for changes of an earlier page */
const RETRY = 3000;

/** ms after a step until other tabs are told the new state of the level */
const TELL_AFTER = 100;

/** shown until a page that has just opened a level knows whether it may write it */
const ASKING = 'checking whether another tab has this level open';

/**
 * Opens a level of the storage, including unsaved changes of an earlier page. Resolves when it is known whether this page may
 * write it.
 * @param remembered the level as this page last had it open: its history continues if nothing has changed it since, and what the
 * page holds is held again
 */
export async function openLevel(id: string, surroundings: Surroundings, remembered: Remembered | null = null): Promise<Opening> {
  const answer = await surroundings.storage.read(id);
  if (!answer.ok) return { ok: false, kind: 'failed', error: answer.error };
  const { text, etag } = answer.value;
  const reading = readStored(answer.value);
  if (!reading.ok) return { ok: false, kind: 'invalid', text: text ?? '', etag, problems: reading.problems };
  // The id may now belong to another level: the history continues only if the file is still the same.
  const fresh = createEditedLevel(reading.file);
  const held = remembered?.held ?? null;
  const goesOn = remembered !== null && (held !== null || isSame(remembered.level.file(), fresh.file()));
  const level = goesOn ? remembered.level : fresh;
  const base = held ?? { file: level.file(), etag };
  const opened = new LevelOnPage(id, surroundings, level, base, answer.value.readOnly, held !== null);
  await opened.decided;
  return { ok: true, opened };
}

class LevelOnPage implements OpenedLevel {
  readonly saver: Saver;
  readonly versions: LevelVersions;
  readonly lock: WriterLock;
  readonly holding: StoreApi<boolean>;
  readonly keeping = createStore<Keeping | null>(() => null);
  /** Resolves when it is known whether this page may write. */
  readonly decided: Promise<void>;
  recovered: Recovery | null = null;
  /** This page's journal of the level; null if another page keeps it. */
  private kept: LevelJournal | null = null;
  /** Shows what another page does that writes the level. */
  private readonly follower: WriterFollower;
  /** Resolves when the consequences of this page's role are done. */
  private settled: Promise<void> = Promise.resolve();
  private stopShowing = () => {};
  private cancelRetry = () => {};
  private readonly telling: Throttled;
  private readonly stops: readonly (() => void)[];

  constructor(
    private at: string,
    private readonly surroundings: Surroundings,
    readonly level: EditedLevel,
    base: DiskBase,
    unwritable: string | null,
    /** Whether the level has changes that this page could only hold. */
    private hasHeld: boolean,
  ) {
    const { storage, journal, versions, timers, locks, channel, folder } = surroundings;
    this.versions = versions.follow(placeOf(folder, at), level);
    this.saver = createSaver(at, level, {
      storage,
      timers,
      base,
      unwritable,
      onDisk: (file, etag, by) => {
        this.kept?.onDisk(file, etag);
        if (this.lock.store.getState() === 'writer') this.versions.note(file, by);
      },
      onSent: (file) => this.kept?.onSent(file),
      onStep: (event) => this.follower.stepped(event),
    });
    this.follower = new WriterFollower(level, this.saver, timers);
    this.holding = this.follower.holding;
    this.saver.setReadOnly(ASKING, true);
    const name = this.lockOf(at);
    this.lock = claimLevel({
      locks,
      channel: channel(name),
      timers,
      name,
      beforeHandOver: () => {
        this.telling.now();
        return this.saver.flush();
      },
      onShown: (theirs) => this.follower.show(theirs),
      shown: () => this.shown(),
    });
    this.telling = throttled(TELL_AFTER, () => this.lock.tell(this.shown()), timers);
    this.decided = this.followRole();
    this.stops = [
      // writing out a large level takes long: the user must not wait for it
      level.onStep(() => this.telling.soon()),
      // the database may contain unsaved changes of an earlier page
      journal.onAdopted(() => {
        if (this.kept !== null) this.settled = this.settled.then(() => this.takeUp());
      }),
    ];
  }

  id(): string {
    return this.at;
  }

  moved(to: string, etag: string): void {
    const { journal, folder, channel } = this.surroundings;
    const from = this.at;
    this.at = to;
    this.saver.moved(to, etag);
    this.versions.moveTo(placeOf(folder, to));
    const name = this.lockOf(to);
    this.lock.moveTo(name, channel(name));
    if (this.kept === null) return;
    const next = journal.follow(placeOf(folder, to), this.level, this.saver.base());
    this.keep(next);
    // by then the level may have its old name again
    void next.settled().then(() => (this.at === from ? undefined : journal.forget(placeOf(folder, from))));
  }

  dropHeld(): void {
    this.follower.drop();
  }

  remember(): Remembered {
    return { level: this.level, held: this.hasHeld ? this.saver.base() : null };
  }

  async close(): Promise<void> {
    this.level.seal();
    this.telling.now();
    await this.settled;
    await this.saver.flush();
    for (const stop of this.stops) stop();
    this.hasHeld = this.holding.getState();
    this.follower.close();
    this.saver.close();
    this.versions.close();
    await this.kept?.settled();
    this.keep(null);
    this.lock.close();
  }

  private lockOf(id: string): string {
    return `gravity-quest-editor ${placeOf(this.surroundings.folder, id)}`;
  }

  /** What other tabs show of the level. */
  private shown(): Shown {
    const { file, etag } = this.saver.base();
    return { text: levelText(this.level.committedFile()), base: { text: levelText(file), etag } };
  }

  /** @returns resolves when the first role is known and its consequences are done */
  private followRole(): Promise<void> {
    return new Promise((resolve) => {
      const decide = () => {
        const role = this.lock.store.getState();
        if (role === 'waiting') return;
        this.settled = this.onRole(role);
        void this.settled.then(resolve);
      };
      this.lock.store.subscribe(decide);
      decide();
    });
  }

  private onRole(role: Role): Promise<void> {
    if (role === 'writer') {
      // the file may have changed while no page had the level open
      const { file, etag } = this.saver.base();
      if (etag !== null && !this.hasHeld && !this.holding.getState()) this.versions.note(file, 'found');
      return this.takeUp();
    }
    // what this page could not write before it lost the level
    const isStranded = this.kept !== null && this.saver.isUnsaved();
    this.keep(null);
    this.follower.begin(isStranded || this.hasHeld);
    this.hasHeld = false;
    return Promise.resolve();
  }

  /** Makes this page the writer, including what earlier writers left in the journal. */
  private async takeUp(): Promise<void> {
    const { level, saver, lock } = this;
    const { journal, folder } = this.surroundings;
    let left: Recovery | null;
    try {
      left = await journal.recover(placeOf(folder, this.at));
    } catch {
      // following now would overwrite what an earlier page has left
      if (lock.store.getState() === 'writer') this.writeUnkept();
      return;
    }
    if (lock.store.getState() !== 'writer') return;
    this.follower.end();
    // a write whose answer was lost may have reached the disk
    if (left !== null && !isSame(left.file, saver.base().file)) {
      // this page may have changes of its own that it could not write before it lost the level
      const { file } = mergeLevels(saver.base().file, level.committedFile(), left.file);
      // the saver merges it with what is on disk now
      saver.restart(left.base);
      level.replace('Recovered', file);
      this.recovered ??= left;
    }
    this.keep(journal.follow(placeOf(folder, this.at), level, saver.base()));
    saver.setReadOnly(null);
    saver.refresh();
  }

  /** Writes without a journal, and asks for the journal again later. */
  private writeUnkept(): void {
    this.keeping.setState('failing', true);
    this.cancelRetry = this.surroundings.timers.after(RETRY, () => {
      if (this.kept === null) this.settled = this.onRole(this.lock.store.getState());
    });
    this.follower.end();
    this.saver.setReadOnly(null);
    this.saver.refresh();
  }

  private keep(journal: LevelJournal | null): void {
    this.stopShowing();
    this.cancelRetry();
    this.kept?.close();
    this.kept = journal;
    const show = () => this.keeping.setState(journal?.keeping.getState() ?? null, true);
    this.stopShowing = journal?.keeping.subscribe(show) ?? (() => {});
    show();
  }
}
