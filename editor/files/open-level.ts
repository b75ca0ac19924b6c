import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, type Problem } from '../../schema/index.ts';
import { createEditedLevel, type EditedLevel, isSame } from '../document/index.ts';
import type { Journal, Keeping, LevelJournal, Recovery } from '../journal/index.ts';
import { readStored, readText } from './disk-text.ts';
import type { DiskBase } from './known-disk.ts';
import type { LevelStorage, StorageError } from './level-storage.ts';
import { mergeLevels } from './merge.ts';
import { createSaver, type Saver } from './saver.ts';
import type { Timers } from './timers.ts';
import { type Channel, claimLevel, type Role, type WriterLock } from './writer-lock.ts';

/** What a page offers and a test replaces. */
export interface Surroundings {
  readonly storage: LevelStorage;
  readonly journal: Journal;
  readonly timers: Timers;
  /** A name of the folder that is the same in every run: `folder.id` of its list. */
  readonly folder: string;
  readonly locks: Pick<LockManager, 'request'> | null;
  /** A channel by name, between the pages of this browser; null where there is none. */
  readonly channel: (name: string) => Channel | null;
}

/** A level that is open: edited, kept, saved. */
export interface OpenedLevel {
  /** Changes when the level is renamed. */
  id(): string;
  readonly level: EditedLevel;
  readonly saver: Saver;
  readonly lock: WriterLock;
  /** Whether what is not saved would outlive this page; null: this page does not keep the level, since another one does. */
  readonly keeping: StoreApi<Keeping | null>;
  /** What an earlier page had changed and not saved; it is in the level again, as a step that can be undone. */
  readonly recovered: Recovery | null;
  /** The level was renamed. */
  moved(id: string, etag: string): void;
  /** Writes what is unsaved and lets go of the level. What could not be written stays in the journal. */
  close(): Promise<void>;
}

export type Opening =
  | { readonly ok: true; readonly opened: OpenedLevel }
  /** Not a level: it can be looked at and edited as text. */
  | {
      readonly ok: false;
      readonly kind: 'invalid';
      readonly text: string;
      readonly etag: string | null;
      readonly problems: readonly Problem[];
    }
  | { readonly ok: false; readonly kind: 'failed'; readonly error: StorageError };

const placeOf = (folder: string, id: string): string => `${folder}/${id}`;

/** After so long the journal is asked again for what an earlier page has left, ms. */
const RETRY = 3000;

/** So long after a step other tabs are told what the level is like, ms. */
const TELL_AFTER = 100;

/** Until a page that has just opened a level knows whether it may write it. */
const ASKING = 'asking whether another tab has this level open';

/**
 * Opens a level of the storage, with what an earlier page had not saved. Resolves when it is known whether this page may write it.
 * @param remembered the level as this page had it open before: its history goes on if nothing has changed it since
 */
export async function openLevel(id: string, surroundings: Surroundings, remembered: EditedLevel | null = null): Promise<Opening> {
  const answer = await surroundings.storage.read(id);
  if (!answer.ok) return { ok: false, kind: 'failed', error: answer.error };
  const { text, etag } = answer.value;
  const reading = readStored(answer.value);
  if (!reading.ok) return { ok: false, kind: 'invalid', text: text ?? '', etag, problems: reading.problems };
  // an id may have become another level's meanwhile: a history goes on only where its level is still what is there
  const fresh = createEditedLevel(reading.file);
  const level = remembered !== null && isSame(remembered.file(), fresh.file()) ? remembered : fresh;
  return { ok: true, opened: await begin(id, surroundings, level, { file: level.file(), etag }, answer.value.readOnly) };
}

async function begin(
  id: string,
  { storage, journal, timers, folder, locks, channel }: Surroundings,
  level: EditedLevel,
  base: DiskBase,
  unwritable: string | null,
): Promise<OpenedLevel> {
  let at = id;
  let kept: LevelJournal | null = null;
  const keeping = createStore<Keeping | null>(() => null);
  let stopShowing = () => {};
  let cancelRetry = () => {};
  const keep = (journal: LevelJournal | null) => {
    stopShowing();
    cancelRetry();
    kept?.close();
    kept = journal;
    const show = () => keeping.setState(kept?.keeping.getState() ?? null, true);
    stopShowing = kept?.keeping.subscribe(show) ?? (() => {});
    show();
  };
  let recovered: Recovery | null = null;
  /** This page lost the level to another one before it could write its changes. */
  let isStranded = false;
  const saver = createSaver(id, level, {
    storage,
    timers,
    base,
    unwritable,
    onDisk: (file, etag) => kept?.onDisk(file, etag),
    onSent: (file) => kept?.onSent(file),
  });
  saver.setReadOnly(ASKING, true);
  const lockOf = (of: string): string => `gravity-quest-editor ${placeOf(folder, of)}`;
  const name = lockOf(id);
  const lock = claimLevel({
    locks,
    channel: channel(name),
    timers,
    name,
    beforeHandOver: () => {
      tellNow();
      return saver.flush();
    },
    onShown({ text, base }) {
      const [theirs, disk] = [readText(text), readText(base.text)];
      if (!theirs.ok || !disk.ok || isStranded || lock.store.getState() !== 'reader') return;
      level.replace('Changed in another tab', theirs.file);
      saver.restart({ file: disk.file, etag: base.etag });
    },
    shown: () => shown(),
  });
  const shown = () => {
    const { file, etag } = saver.base();
    return { text: formatLevel(level.settledFile()), base: { text: formatLevel(file), etag } };
  };
  let cancelTelling: (() => void) | null = null;
  const tellNow = () => {
    if (cancelTelling === null) return;
    cancelTelling();
    cancelTelling = null;
    lock.tell(shown());
  };
  // a large level takes long to write out: what a person does must not wait for that
  const tellSoon = () => {
    cancelTelling ??= timers.after(TELL_AFTER, tellNow);
  };

  /** From now on this page writes: with what whoever wrote before has left in the journal. */
  const takeUp = async () => {
    let left: Recovery | null;
    try {
      left = await journal.recover(placeOf(folder, at));
    } catch {
      // to follow now would write over what an earlier page has left
      if (lock.store.getState() !== 'writer') return;
      keeping.setState('failing', true);
      cancelRetry = timers.after(RETRY, () => {
        if (kept === null) settled = onRole(lock.store.getState());
      });
      saver.setReadOnly(null);
      saver.refresh();
      return;
    }
    if (lock.store.getState() !== 'writer') return;
    // what was cut off between the disk and its answer has reached the disk
    if (left !== null && !isSame(left.file, saver.base().file)) {
      // this page may have changes of its own, that it could not write when it lost the level
      const { file } = mergeLevels(saver.base().file, level.settledFile(), left.file);
      // the saver brings it together with what is there now
      saver.restart(left.base);
      level.replace('Recovered', file);
      recovered ??= left;
    }
    isStranded = false;
    keep(journal.follow(placeOf(folder, at), level, saver.base()));
    saver.setReadOnly(null);
    saver.refresh();
  };
  const giveUp = () => {
    isStranded = kept !== null && saver.isUnsaved();
    keep(null);
    saver.setReadOnly('another tab has this level open', !isStranded);
  };
  const onRole = (role: Role) => (role === 'writer' ? takeUp() : Promise.resolve(giveUp()));
  let settled: Promise<void> = Promise.resolve();
  const decided = new Promise<void>((resolve) => {
    const decide = () => {
      const role = lock.store.getState();
      if (role === 'waiting') return;
      settled = onRole(role);
      void settled.then(resolve);
    };
    lock.store.subscribe(decide);
    decide();
  });
  const stops = [
    level.onStep(tellSoon),
    // the database may have what an earlier page did not save
    journal.onAdopted(() => {
      if (kept !== null) settled = settled.then(takeUp);
    }),
  ];
  await decided;

  return {
    id: () => at,
    level,
    saver,
    lock,
    keeping,
    get recovered() {
      return recovered;
    },
    moved(to, etag) {
      const from = at;
      at = to;
      saver.moved(to, etag);
      const name = lockOf(to);
      lock.moveTo(name, channel(name));
      if (kept === null) return;
      const next = journal.follow(placeOf(folder, to), level, saver.base());
      keep(next);
      void next.settled().then(() => journal.forget(placeOf(folder, from)));
    },
    async close() {
      level.seal();
      tellNow();
      await settled;
      await saver.flush();
      for (const stop of stops) stop();
      saver.close();
      await kept?.settled();
      keep(null);
      lock.close();
    },
  };
}
