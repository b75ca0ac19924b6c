import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Choices, type Conflict, mergeLevels } from '../../../review/index.ts';
import type { LevelFile, Problem, ReadResponse } from '../../../schema/index.ts';
import { type DocumentEvent, type EditedLevel, levelText } from '../document/index.ts';
import { type DiskBase, diskNews, KnownDisk } from './known-disk.ts';
import type { LevelStorage, StorageError } from './level-storage.ts';
import { atMost, type Timers, WritePacing } from './timers.ts';

/** Keeps the disk up to date with a level, and the level with the disk. */
export interface Saver {
  readonly store: StoreApi<SaveState>;
  /** Whether the level differs from the file on disk, or the state of the file is uncertain. */
  isUnsaved(): boolean;
  /** The disk may have changed: looks again. @param etag the current etag, if known: nothing is read if it is not new */
  refresh(etag?: string | null): void;
  /** After a conflict: continues with the choices; unresolved conflicts are mine. */
  resolve(choices: Choices): void;
  /** After `deleted` or `unreadable`, or instead of a merge: overwrites the file with the page's version. */
  keepMine(): void;
  /** Replaces the level by the version on disk, as a step that can be undone. */
  takeTheirs(): void;
  /** Saves the changes at once. @returns whether everything is on disk */
  flush(): Promise<boolean>;
  /**
   * Stops writing, because of `why`; null allows writing again.
   * @param follows whether the level shows the work of another page: then differences from the disk are not changes of this
   * page
   */
  setReadOnly(why: string | null, follows?: boolean): void;
  /** The state on disk, as known. */
  base(): DiskBase;
  /** Starts over from what an earlier page knew about the disk, to merge its changes with the current file. */
  restart(base: DiskBase): void;
  /** The storage can be reached again: retries at once. */
  retry(): void;
  /** The level was renamed. */
  moved(id: string, etag: string): void;
  close(): void;
}

interface SaverOptions {
  readonly storage: LevelStorage;
  readonly timers: Timers;
  readonly base: DiskBase;
  /** Why the file can't be written, as known on opening. */
  readonly unwritable?: string | null;
  /** Called when a version is on disk, written by this page or another program. */
  readonly onDisk?: (file: LevelFile, etag: string | null, by: 'page' | 'other') => void;
  /** Called when a version is about to be sent, so that it may be on disk from now on. It is sent when the promise resolves. */
  readonly onSent?: (file: LevelFile) => Promise<unknown> | undefined;
  /** Called after each step of the level, except those that bring in the state on disk. */
  readonly onStep?: (event: DocumentEvent) => void;
}

/** After these errors, it is uncertain whether the text has reached the disk: it may have been written and replaced at once. */
const IN_DOUBT: readonly StorageError['code'][] = ['unreachable', 'unexpected', 'failed', 'unknown-level', 'unknown-folder'];

/** ms that a save waits for the journal, so that saving works even if the browser's database hangs */
const PATIENCE = 1000;

/** Follows a level and writes it after every change; at most one request is in flight. */
export const createSaver = (id: string, level: EditedLevel, options: SaverOptions): Saver => new LevelSaver(id, level, options);

/** A version on disk that could not be merged with the level; nothing is written until that is resolved. */
interface Blocked {
  /** null: the file was deleted */
  readonly theirs: ReadResponse | null;
  /** null: it is not a level */
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
  /** Why the file can't be written, as far as known; writes are tried nevertheless. */
  private unwritable: string | null;
  /** Whether the level shows the work of another page. */
  private isFollower = false;
  private blocked: Blocked | null = null;
  /** Whether the level is being replaced by the version on disk, which is no change of this page. */
  private isTaking = false;
  private request: Promise<void> | null = null;
  /** number of writes begun */
  private requests = 0;
  private isClosed = false;

  constructor(
    private id: string,
    private readonly level: EditedLevel,
    { storage, timers, base, unwritable = null, onDisk, onSent, onStep }: SaverOptions,
  ) {
    this.storage = storage;
    this.timers = timers;
    this.onSent = onSent;
    this.unwritable = unwritable;
    this.disk = new KnownDisk(level, base, onDisk);
    this.pacing = new WritePacing(timers, () => void this.send());
    this.store = createStore<SaveState>(() => (this.disk.differs() ? { kind: 'unsaved' } : { kind: 'saved' }));
    this.stop = level.onStep((event) => {
      if (this.isTaking) return;
      onStep?.(event);
      this.changed();
    });
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
    const merged = mergeLevels(disk.base.file, level.committedFile(), blocked.file, choices, disk.sent);
    if (!this.take('Merged with the disk', merged.file)) return;
    disk.holds(blocked.file, blocked.theirs.etag, 'other');
    this.goOn();
  }

  keepMine(): void {
    const { blocked, disk, pacing } = this;
    if (blocked === null) return;
    // the next write is based on the current file, so it succeeds
    disk.overwrite(blocked.file ?? disk.base.file, blocked.theirs?.etag ?? null);
    this.blocked = null;
    pacing.beginAnew();
    pacing.writeNow();
  }

  takeTheirs(): void {
    const { blocked, disk, level } = this;
    if (blocked?.file == null || blocked.theirs === null || !this.take('Taken from the disk', blocked.file)) return;
    disk.holds(level.committedFile(), blocked.theirs.etag, 'other');
    this.goOn();
  }

  async flush(): Promise<boolean> {
    // changes made while a request is in flight take another request
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

  /** Shows the state that holds while nothing is in flight. */
  private showResting(): void {
    const { readOnly, unwritable, disk } = this;
    if (readOnly !== null) this.show({ kind: 'readOnly', why: readOnly, unsaved: !this.isFollower && disk.differs() });
    else if (this.blocked !== null) return;
    else if (disk.differs()) this.show({ kind: 'unsaved' });
    else this.show(unwritable === null ? { kind: 'saved' } : { kind: 'readOnly', why: unwritable, unsaved: false });
  }

  /** The level may have changed: makes sure that it is written. */
  private changed(): void {
    const { pacing } = this;
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
    // while the storage does not answer, changes are no reason to ask more often
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
    const file = this.level.committedFile();
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
    const answer = await this.storage.write(this.id, levelText(file), disk.base.etag);
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

  /** Reads the file; again if something was written in the meantime, as the result may be outdated. */
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

  /** Handles the state on disk: brings file and level together. @param current null: there is no file */
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
        disk.holds(news.file, current.etag, 'page');
        break;
      case 'changed':
        this.take('Changed on disk', news.theirs);
        disk.holds(level.committedFile(), current.etag, 'other');
        break;
      case 'both changed': {
        const { theirs, merged } = news;
        // A page that may not write does not ask the user now. Once it may write, its write conflicts, and the user is asked
        // then.
        if (merged.conflicts.length > 0 && this.readOnly !== null) return;
        if (merged.conflicts.length > 0 || !this.take('Merged with the disk', merged.file)) {
          this.block({ theirs: current, file: theirs }, { kind: 'conflict', conflicts: merged.conflicts });
          return;
        }
        disk.holds(theirs, current.etag, 'other');
      }
    }
    this.goOn();
  }

  private block(blocked: Blocked, state: SaveState): void {
    this.blocked = blocked;
    this.show(state);
  }

  /** Continues after a block. */
  private goOn(): void {
    this.blocked = null;
    this.pacing.forgetFailures();
    this.showResting();
    this.changed();
  }

  /** Replaces the level by a version from disk. @returns whether the level accepts it */
  private take(label: string, file: LevelFile): boolean {
    this.isTaking = true;
    const { ok } = this.level.replace(label, file);
    this.isTaking = false;
    return ok;
  }
}

/** Where the work is stored, as the user sees it. In all states but the first two, the journal has what the disk lacks. */
export type SaveState =
  | { readonly kind: 'saved' }
  | { readonly kind: 'saving' }
  /** will be written in a moment */
  | { readonly kind: 'unsaved' }
  /** no answer; retried automatically */
  | { readonly kind: 'offline'; readonly message: string; readonly hint: string }
  /** the disk does not accept it; retried automatically */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string }
  /** both the disk and this page changed the same thing: `resolve` continues */
  | { readonly kind: 'conflict'; readonly conflicts: readonly Conflict[] }
  /** the file was deleted: `keepMine` writes it again */
  | { readonly kind: 'deleted' }
  /** the file is no longer a valid level: continues once the file is fixed, or `keepMine` overwrites it */
  | { readonly kind: 'unreadable'; readonly problems: readonly Problem[] }
  /** `unsaved`: changes of this page that were not written before another page took the level */
  | { readonly kind: 'readOnly'; readonly why: string; readonly unsaved: boolean };
