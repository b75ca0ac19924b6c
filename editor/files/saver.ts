import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, type LevelFile, type ReadResponse } from '../../schema/index.ts';
import { type EditedLevel, isSame } from '../document/index.ts';
import { readStored } from './disk-text.ts';
import type { LevelStorage, StorageError } from './level-storage.ts';
import { type Choices, mergeLevels } from './merge.ts';
import type { SaveState } from './save-state.ts';
import { atMost, type Timers } from './timers.ts';

export interface DiskBase {
  readonly file: LevelFile;
  /** null: not on the disk */
  readonly etag: string | null;
  /** Sent to the disk since, without an answer: each of them may be what is there. None when left out. */
  readonly sent?: readonly LevelFile[];
}

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

/** After the last change, ms: in time for half a second with the write itself. */
const PAUSE = 200;
/** Changes without a pause are written after so long, ms. */
const LONGEST_PAUSE = 2000;
/** So long a save waits for the journal, ms: a browser whose database hangs saves all the same. */
const PATIENCE = 1000;
/** Waits between attempts, ms; the last is repeated. */
const BACKOFF = [500, 1000, 2000, 5000, 10_000] as const;

/** Follows a level and writes it after every change; at most one request is on its way. */
export function createSaver(
  id: string,
  level: EditedLevel,
  { storage, timers, base, unwritable = null, onDisk, onSent }: SaverOptions,
): Saver {
  let at = id;
  let disk: DiskBase = base;
  /** Why this page may not write. */
  let readOnly: string | null = null;
  /** Why nobody may, as far as is known; a write is tried all the same. */
  let notWritable = unwritable;
  let follows = false;
  /** What is on the disk and could not be brought together with this: nothing is written meanwhile. */
  let blocked: { readonly theirs: ReadResponse | null; readonly file: LevelFile | null } | null = null;
  /** The level takes over what is on the disk: no change of this page. */
  let adopting = false;
  /** Written by `keepMine`, whatever it is like. */
  let forced = false;
  let request: Promise<void> | null = null;
  let requests = 0;
  let attempts = 0;
  let firstUnsaved: number | null = null;
  let cancel = () => {};
  let isClosed = false;

  const sent = () => disk.sent ?? [];
  const differs = () => forced || sent().length > 0 || !isSame(level.settledFile(), disk.file) || disk.etag === null;
  const store = createStore<SaveState>(() => (differs() ? { kind: 'unsaved' } : { kind: 'saved' }));
  const show = (state: SaveState) => {
    if (!isClosed) store.setState(state, true);
  };
  const showResting = () => {
    if (readOnly !== null) show({ kind: 'readOnly', why: readOnly, unsaved: !follows && differs() });
    else if (blocked !== null) return;
    else if (differs()) show({ kind: 'unsaved' });
    else show(notWritable === null ? { kind: 'saved' } : { kind: 'readOnly', why: notWritable, unsaved: false });
  };
  const nowOnDisk = (file: LevelFile, etag: string | null) => {
    disk = { file, etag };
    onDisk?.(file, etag);
  };
  const schedule = (wait: number) => {
    cancel();
    cancel = timers.after(wait, () => void send());
  };
  const changed = () => {
    if (adopting) return;
    if (readOnly !== null || blocked !== null) {
      showResting();
      return;
    }
    if (!differs()) {
      firstUnsaved = null;
      if (request === null) {
        attempts = 0;
        cancel();
        showResting();
      }
      return;
    }
    firstUnsaved ??= timers.now();
    if (request !== null) return;
    // while nobody answers a change is no reason to ask more often
    if (attempts > 0) return;
    show({ kind: 'unsaved' });
    schedule(Math.max(0, Math.min(PAUSE, firstUnsaved + LONGEST_PAUSE - timers.now())));
  };

  const failed = (error: StorageError): void => {
    if (error.code === 'conflict') incoming(error.current);
    else if (error.code === 'unknown-level') incoming(null);
    else {
      const { code, message, hint } = error;
      if (code === 'not-writable') show({ kind: 'readOnly', why: message, unsaved: true });
      else show({ kind: code === 'unreachable' ? 'offline' : 'failing', message, hint });
      schedule(BACKOFF[Math.min(attempts++, BACKOFF.length - 1)]);
    }
  };
  const write = async () => {
    const file = level.settledFile();
    requests++;
    show({ kind: 'saving' });
    firstUnsaved = null;
    const before = sent();
    disk = { ...disk, sent: [...before.filter((other) => other !== file), file] };
    const noted = onSent?.(file);
    if (noted !== undefined) await atMost(PATIENCE, noted, timers);
    if (isClosed || readOnly !== null) {
      disk = { ...disk, sent: before };
      request = null;
      return;
    }
    const answer = await storage.write(at, formatLevel(file), disk.etag);
    request = null;
    if (!answer.ok) {
      if (!IN_DOUBT.includes(answer.error.code)) disk = { ...disk, sent: before };
      failed(answer.error);
      return;
    }
    attempts = 0;
    forced = false;
    notWritable = answer.value.readOnly;
    nowOnDisk(file, answer.value.etag);
    showResting();
    if (differs()) changed();
  };
  const send = (): Promise<void> => {
    cancel();
    if (isClosed || readOnly !== null || blocked !== null || (!differs() && request === null)) return Promise.resolve();
    request ??= write();
    return request;
  };

  const put = (label: string, file: LevelFile): boolean => {
    adopting = true;
    const { ok } = level.replace(label, file);
    adopting = false;
    return ok;
  };
  const goOn = () => {
    blocked = null;
    attempts = 0;
    showResting();
    changed();
  };
  function incoming(current: ReadResponse | null): void {
    if (isClosed) return;
    if (current !== null && current.etag === disk.etag) {
      if (blocked !== null) goOn();
      return;
    }
    if (current === null) {
      blocked = { theirs: null, file: null };
      show({ kind: 'deleted' });
      return;
    }
    const reading = readStored(current);
    if (!reading.ok) {
      blocked = { theirs: current, file: null };
      show({ kind: 'unreadable', problems: reading.problems });
      return;
    }
    const theirs = reading.file;
    // the server died, or the line broke, before it could answer
    const own = sent().find((file) => isSame(file, theirs));
    if (own !== undefined) {
      nowOnDisk(own, current.etag);
      goOn();
      return;
    }
    // a drag that goes on is mine as far as it went
    level.seal();
    const mine = level.settledFile();
    if (!differs()) {
      put('Changed on disk', theirs);
      nowOnDisk(level.settledFile(), current.etag);
      goOn();
      return;
    }
    const merged = mergeLevels(disk.file, mine, theirs, new Map(), sent());
    // who may not write is asked once it may: the write will not fit what is there
    if (merged.conflicts.length > 0 && readOnly !== null) return;
    if (merged.conflicts.length > 0 || !put('Merged with the disk', merged.file)) {
      blocked = { theirs: current, file: theirs };
      show({ kind: 'conflict', conflicts: merged.conflicts });
      return;
    }
    nowOnDisk(theirs, current.etag);
    goOn();
  }

  /** Reads what is there; again when something was written meanwhile, since what was read may be older. */
  const look = async () => {
    for (;;) {
      while (request !== null) await request;
      const before = requests;
      const answer = await storage.read(at);
      if (isClosed) return;
      if (before !== requests || request !== null) continue;
      if (answer.ok) {
        notWritable = answer.value.readOnly;
        if (attempts === 0 && request === null) showResting();
        incoming(answer.value);
      } else if (answer.error.code === 'unknown-level') incoming(null);
      return;
    }
  };
  function setReadOnly(why: string | null, isFollower = false): void {
    readOnly = why;
    follows = isFollower;
    if (why !== null) cancel();
    showResting();
    if (why === null) changed();
  }

  const stop = level.onStep(changed);
  if (differs()) changed();
  return {
    store,
    isUnsaved: differs,
    refresh(etag) {
      if (etag === undefined || etag !== disk.etag || blocked !== null) void look();
    },
    resolve(choices) {
      if (blocked?.file == null || blocked.theirs === null) return;
      const { file: theirs } = blocked;
      level.seal();
      const merged = mergeLevels(disk.file, level.settledFile(), theirs, choices, sent());
      if (!put('Merged with the disk', merged.file)) return;
      nowOnDisk(theirs, blocked.theirs.etag);
      goOn();
    },
    keepMine() {
      if (blocked === null) return;
      // the next write is based on what is there now, so it stands
      disk = { file: blocked.file ?? disk.file, etag: blocked.theirs?.etag ?? null };
      blocked = null;
      forced = true;
      attempts = 0;
      firstUnsaved = timers.now();
      schedule(0);
    },
    takeTheirs() {
      if (blocked?.file == null || blocked.theirs === null || !put('Taken from the disk', blocked.file)) return;
      nowOnDisk(level.settledFile(), blocked.theirs.etag);
      goOn();
    },
    async flush() {
      // what was changed while a request was on its way takes another one
      for (let i = 0; i < 3 && (differs() || request !== null); i++) await send();
      return !differs();
    },
    setReadOnly,
    base: () => disk,
    restart(older) {
      disk = older;
      blocked = null;
      changed();
    },
    retry() {
      if (attempts === 0) return;
      attempts = 0;
      if (request === null) schedule(0);
    },
    moved(to, etag) {
      at = to;
      disk = { ...disk, etag };
    },
    close() {
      isClosed = true;
      stop();
      cancel();
    },
  };
}
