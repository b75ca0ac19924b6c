import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, type LevelFile, type ReadResponse } from '../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { diskNews } from './disk-news.ts';
import { type DiskBase, KnownDisk } from './known-disk.ts';
import type { LevelStorage, StorageError } from './level-storage.ts';
import { type Choices, mergeLevels } from './merge.ts';
import type { SaveState } from './save-state.ts';
import { atMost, type Timers } from './timers.ts';
import { WritePacing } from './write-pacing.ts';

/** Keeps the disk up to date with a level, and the level with the disk. */
export interface Saver {
  readonly store: StoreApi<SaveState>;
  /** Whether the level differs from what is known to be on the disk, or nothing is known for certain. */
  isUnsaved(): boolean;
  /** The disk may have changed: looks what is there now. @param etag what is there, when that is known: nothing is read if it is nothing new */
  refresh(etag?: string | null): void;
  /** After a conflict: goes on with what was chosen; what was not chosen is mine. */
  resolve(choices: Choices): void;
  /** After `deleted` or `unreadable`, or instead of any merge: writes what is in the page over what is on the disk. */
  keepMine(): void;
  /** Takes what is on the disk, as a step that can be undone. */
  takeTheirs(): void;
  /** Writes what is unsaved at once. @returns whether all is on the disk */
  flush(): Promise<boolean>;
  /**
   * Writes no more, because of `why`; null lets it write again.
   * @param follows the level shows what another page does: what differs from the disk is not this page's
   */
  setReadOnly(why: string | null, follows?: boolean): void;
  /** What is known to be on the disk. */
  base(): DiskBase;
  /** Begins anew from what an earlier page knew to be on the disk, to bring its changes together with what is there now. */
  restart(base: DiskBase): void;
  /** The storage can be reached again: what waits is tried at once. */
  retry(): void;
  /** The level has another id from now on. */
  moved(id: string, etag: string): void;
  close(): void;
}

export interface SaverOptions {
  readonly storage: LevelStorage;
  readonly timers: Timers;
  readonly base: DiskBase;
  /** Why the file may not be written when it is opened. */
  readonly unwritable?: string | null;
  /** Something is on the disk now, written by this page or by others. */
  readonly onDisk?: (file: LevelFile, etag: string | null) => void;
  /** This is about to be sent to the disk: from now on it may be there. It is sent when the promise resolves. */
  readonly onSent?: (file: LevelFile) => Promise<unknown> | undefined;
}

/** After these nobody knows whether the text has reached the disk: it may have, and been taken away at once. */
const IN_DOUBT: readonly StorageError['code'][] = ['unreachable', 'unexpected', 'failed', 'unknown-level', 'unknown-folder'];

/** So long a save waits for the journal, ms: a browser whose database hangs saves all the same. */
const PATIENCE = 1000;

/** Follows a level and writes it after every change; at most one request is on its way. */
export const createSaver = (id: string, level: EditedLevel, options: SaverOptions): Saver => new LevelSaver(id, level, options);

/** What is on the disk and could not be brought together with the level: nothing is written meanwhile. */
interface Blocked {
  /** null: the file was deleted */
  readonly theirs: ReadResponse | null;
  /** null: it is no level */
  readonly file: LevelFile | null;
}

class LevelSaver implements Saver {
  readonly store: StoreApi<SaveState>;
  private readonly storage: LevelStorage;
  private readonly timers: Timers;
  private readonly onSent: SaverOptions['onSent'];
  private readonly disk: KnownDisk;
  private readonly pacing: WritePacing;
  private readonly stop: () => void;
  /** Why this page may not write. */
  private readOnly: string | null = null;
  /** Why nobody may, as far as is known; a write is tried all the same. */
  private unwritable: string | null;
  /** The level shows what another page does. */
  private isFollower = false;
  private blocked: Blocked | null = null;
  /** The level takes over what is on the disk: no change of this page. */
  private isTaking = false;
  private request: Promise<void> | null = null;
  /** Writes begun. */
  private requests = 0;
  private isClosed = false;

  constructor(
    private id: string,
    private readonly level: EditedLevel,
    { storage, timers, base, unwritable = null, onDisk, onSent }: SaverOptions,
  ) {
    this.storage = storage;
    this.timers = timers;
    this.onSent = onSent;
    this.unwritable = unwritable;
    this.disk = new KnownDisk(level, base, onDisk);
    this.pacing = new WritePacing(timers, () => void this.send());
    this.store = createStore<SaveState>(() => (this.disk.differs() ? { kind: 'unsaved' } : { kind: 'saved' }));
    this.stop = level.onStep(() => this.changed());
    if (this.disk.differs()) this.changed();
  }

  isUnsaved(): boolean {
    return this.disk.differs();
  }

  base(): DiskBase {
    return this.disk.base;
  }

  refresh(etag?: string | null): void {
    if (etag === undefined || etag !== this.disk.base.etag || this.blocked !== null) void this.look();
  }

  resolve(choices: Choices): void {
    const { blocked, disk, level } = this;
    if (blocked?.file == null || blocked.theirs === null) return;
    level.seal();
    const merged = mergeLevels(disk.base.file, level.settledFile(), blocked.file, choices, disk.sent);
    if (!this.take('Merged with the disk', merged.file)) return;
    disk.holds(blocked.file, blocked.theirs.etag);
    this.goOn();
  }

  keepMine(): void {
    const { blocked, disk, pacing } = this;
    if (blocked === null) return;
    // the next write is based on what is there now, so it stands
    disk.overwrite(blocked.file ?? disk.base.file, blocked.theirs?.etag ?? null);
    this.blocked = null;
    pacing.beginAnew();
    pacing.writeNow();
  }

  takeTheirs(): void {
    const { blocked, disk, level } = this;
    if (blocked?.file == null || blocked.theirs === null || !this.take('Taken from the disk', blocked.file)) return;
    disk.holds(level.settledFile(), blocked.theirs.etag);
    this.goOn();
  }

  async flush(): Promise<boolean> {
    // what was changed while a request was on its way takes another one
    for (let i = 0; i < 3 && (this.disk.differs() || this.request !== null); i++) await this.send();
    return !this.disk.differs();
  }

  setReadOnly(why: string | null, follows = false): void {
    this.readOnly = why;
    this.isFollower = follows;
    if (why !== null) this.pacing.cancel();
    this.showResting();
    if (why === null) this.changed();
  }

  restart(base: DiskBase): void {
    this.disk.restart(base);
    this.blocked = null;
    this.changed();
  }

  retry(): void {
    const { pacing } = this;
    if (!pacing.isRetrying) return;
    pacing.forgetFailures();
    if (this.request === null) pacing.writeNow();
  }

  moved(id: string, etag: string): void {
    this.id = id;
    this.disk.moved(etag);
  }

  close(): void {
    this.isClosed = true;
    this.stop();
    this.pacing.cancel();
  }

  private show(state: SaveState): void {
    if (!this.isClosed) this.store.setState(state, true);
  }

  /** Shows the state in which nothing is on its way. */
  private showResting(): void {
    const { readOnly, unwritable, disk } = this;
    if (readOnly !== null) this.show({ kind: 'readOnly', why: readOnly, unsaved: !this.isFollower && disk.differs() });
    else if (this.blocked !== null) return;
    else if (disk.differs()) this.show({ kind: 'unsaved' });
    else this.show(unwritable === null ? { kind: 'saved' } : { kind: 'readOnly', why: unwritable, unsaved: false });
  }

  /** The level may have changed: sees to it that it is written. */
  private changed(): void {
    const { pacing } = this;
    if (this.isTaking) return;
    if (this.readOnly !== null || this.blocked !== null) {
      this.showResting();
      return;
    }
    if (!this.disk.differs()) {
      pacing.noteUnchanged();
      if (this.request !== null) return;
      pacing.forgetFailures();
      pacing.cancel();
      this.showResting();
      return;
    }
    pacing.noteChange();
    // while nobody answers a change is no reason to ask more often
    if (this.request !== null || pacing.isRetrying) return;
    this.show({ kind: 'unsaved' });
    pacing.writeSoon();
  }

  private send(): Promise<void> {
    this.pacing.cancel();
    const hasNothing = !this.disk.differs() && this.request === null;
    if (this.isClosed || this.readOnly !== null || this.blocked !== null || hasNothing) return Promise.resolve();
    this.request ??= this.write();
    return this.request;
  }

  private async write(): Promise<void> {
    const { disk, pacing } = this;
    const file = this.level.settledFile();
    this.requests++;
    this.show({ kind: 'saving' });
    pacing.noteUnchanged();
    const notSent = disk.sends(file);
    const noted = this.onSent?.(file);
    if (noted !== undefined) await atMost(PATIENCE, noted, this.timers);
    if (this.isClosed || this.readOnly !== null) {
      notSent();
      this.request = null;
      return;
    }
    const answer = await this.storage.write(this.id, formatLevel(file), disk.base.etag);
    this.request = null;
    if (!answer.ok) {
      if (!IN_DOUBT.includes(answer.error.code)) notSent();
      this.failed(answer.error);
      return;
    }
    pacing.forgetFailures();
    this.unwritable = answer.value.readOnly;
    disk.written(file, answer.value.etag);
    this.showResting();
    if (disk.differs()) this.changed();
  }

  private failed(error: StorageError): void {
    if (error.code === 'conflict') this.hear(error.current);
    else if (error.code === 'unknown-level') this.hear(null);
    else {
      const { code, message, hint } = error;
      if (code === 'not-writable') this.show({ kind: 'readOnly', why: message, unsaved: true });
      else this.show({ kind: code === 'unreachable' ? 'offline' : 'failing', message, hint });
      this.pacing.writeLater();
    }
  }

  /** Reads what is there; again when something was written meanwhile, since what was read may be older. */
  private async look(): Promise<void> {
    for (;;) {
      while (this.request !== null) await this.request;
      const before = this.requests;
      const answer = await this.storage.read(this.id);
      if (this.isClosed) return;
      if (before !== this.requests || this.request !== null) continue;
      if (answer.ok) {
        this.unwritable = answer.value.readOnly;
        if (!this.pacing.isRetrying && this.request === null) this.showResting();
        this.hear(answer.value);
      } else if (answer.error.code === 'unknown-level') this.hear(null);
      return;
    }
  }

  /** This is on the disk: brings it and the level together. @param current null: nothing is there */
  private hear(current: ReadResponse | null): void {
    if (this.isClosed) return;
    const { level, disk } = this;
    const news = diskNews(level, disk, current);
    if (current === null || news.kind === 'deleted') {
      this.block({ theirs: null, file: null }, { kind: 'deleted' });
      return;
    }
    switch (news.kind) {
      case 'known':
        if (this.blocked !== null) this.goOn();
        return;
      case 'unreadable':
        this.block({ theirs: current, file: null }, { kind: 'unreadable', problems: news.problems });
        return;
      case 'own':
        disk.holds(news.file, current.etag);
        break;
      case 'changed':
        this.take('Changed on disk', news.theirs);
        disk.holds(level.settledFile(), current.etag);
        break;
      case 'both changed': {
        const { theirs, merged } = news;
        // who may not write is asked once it may: the write will not fit what is there
        if (merged.conflicts.length > 0 && this.readOnly !== null) return;
        if (merged.conflicts.length > 0 || !this.take('Merged with the disk', merged.file)) {
          this.block({ theirs: current, file: theirs }, { kind: 'conflict', conflicts: merged.conflicts });
          return;
        }
        disk.holds(theirs, current.etag);
      }
    }
    this.goOn();
  }

  private block(blocked: Blocked, state: SaveState): void {
    this.blocked = blocked;
    this.show(state);
  }

  /** Nothing is in the way any more. */
  private goOn(): void {
    this.blocked = null;
    this.pacing.forgetFailures();
    this.showResting();
    this.changed();
  }

  /** Puts a file from the disk in the place of the level. @returns whether the level takes it */
  private take(label: string, file: LevelFile): boolean {
    this.isTaking = true;
    const { ok } = this.level.replace(label, file);
    this.isTaking = false;
    return ok;
  }
}
