import { createStore, type StoreApi } from 'zustand/vanilla';
import { type LevelFile, readLevel } from '../../../schema/index.ts';
import { applyPatches, type EditedLevel, normalize } from '../document/index.ts';
import {
  createMemoryStore,
  failureOf,
  type JournalEntry,
  type JournalState,
  type JournalStore,
  type Kept,
} from './journal-store.ts';
import { type DiskState, keepLevel, type LevelJournal } from './level-journal.ts';

export interface Journal {
  readonly state: StoreApi<JournalState>;
  /** The browser's database answers after all: open levels recover its changes and follow it from now on. */
  adopt(store: JournalStore): void;
  /** Calls back when a store is adopted. @returns stops it */
  onAdopted(listener: () => void): () => void;
  /** The unsaved changes of a level; null if everything reached the disk. Rejects when the database fails. */
  recover(place: string): Promise<Recovery | null>;
  /** All levels with unsaved changes. Rejects when the database fails. */
  unsaved(): Promise<readonly { readonly place: string; readonly time: number }[]>;
  /**
   * Keeps every step of a level under a place: a name of the level in its folder. Earlier data of the level is replaced by its
   * current state, so call `recover` first.
   * @param base the state on disk: its file, or one of `sent`
   */
  follow(place: string, level: EditedLevel, base: DiskState): LevelJournal;
  /** Deletes the data of a level whose changes the user has discarded. */
  forget(place: string): Promise<void>;
}

/** shown if the page has no database */
const MISSING = {
  message: 'this browser stores no data for this page (a private window?), so unsaved changes are lost when it is closed',
  hint: 'download the level from time to time, or open the editor in an ordinary window',
};

/**
 * A journal of every step, so that nothing is lost when the page dies once the journal says that it is kept.
 * @param store where it is kept; null if the browser has no database: then the state says so, and changes live as long as the
 * page
 * @param now ms since 1970
 * @param after calls back after `ms` and returns a function that cancels; null: a failed write is retried only with the next
 * change
 * @param missing the message for a missing store
 */
export function createJournal(
  store: JournalStore | null,
  now: () => number,
  after: ((ms: number, call: () => void) => () => void) | null = null,
  missing: { readonly message: string; readonly hint: string } = MISSING,
): Journal {
  let isLasting = store !== null;
  let kept = store ?? createMemoryStore();
  const state = createStore<JournalState>(() => (isLasting ? { kind: 'working' } : { ...missing, kind: 'missing' }));
  const listeners = new Set<() => void>();

  const freeRoom = async (except: string) => {
    for (const { place, entries } of await kept.places()) if (entries === 0 && place !== except) await kept.remove(place);
  };

  return {
    state,
    adopt(found) {
      if (isLasting) return;
      isLasting = true;
      kept = found;
      state.setState({ kind: 'working' }, true);
      for (const listener of [...listeners]) listener();
    },
    onAdopted(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    async recover(place) {
      const found = await kept.read(place).catch((error) => {
        state.setState(failureOf(error), true);
        throw error;
      });
      return found === null ? null : recoveryOf(found);
    },
    async unsaved() {
      const found: { place: string; time: number }[] = [];
      for (const { place, time } of await kept.places()) {
        const level = await kept.read(place);
        if (level !== null && (level.entries.length > 0 || level.tip !== null)) found.push({ place, time });
      }
      return found;
    },
    forget: (place) => kept.remove(place),
    follow: (place, level, base) =>
      // A followed level stays in the store where it began; adopting another store means following again.
      keepLevel(place, level, base, { store: kept, isLasting, state, now, after, freeRoom }),
  };
}

/** Changes that never reached the disk. */
export interface Recovery {
  /** The version that the changes started from; the disk may instead have one of `sent`, which were in flight. */
  readonly base: { readonly file: LevelFile; readonly etag: string | null; readonly sent: readonly LevelFile[] };
  /** The level with all changes that could be read. */
  readonly file: LevelFile;
  /** Labels of the changes, oldest first; those that were merged into one text are missing. */
  readonly labels: readonly string[];
  /** When the last change was made, ms since 1970. */
  readonly time: number;
  /** The number of changes at the end that could not be read. */
  readonly lost: number;
}

function fileOf(text: string): LevelFile | null {
  const reading = readLevel(text);
  if (!reading.ok) return null;
  const normalized = normalize(reading.document.file, null);
  return normalized.ok ? normalized.file : null;
}

/** Applies entries as far as possible: each must follow the one before and must fit. */
function replay(start: LevelFile, first: number, entries: readonly JournalEntry[]): { files: LevelFile[]; labels: string[] } {
  let file = start;
  const files: LevelFile[] = [];
  const labels: string[] = [];
  for (const [i, { number, label, patches }] of entries.entries()) {
    if (number !== first + i) break;
    try {
      const next = normalize(applyPatches(file, patches), null);
      if (!next.ok) break;
      file = next.file;
    } catch {
      break;
    }
    files.push(file);
    labels.push(label);
  }
  return { files, labels };
}

/** The unsaved changes of a level; null if everything reached the disk. */
function recoveryOf(found: Kept): Recovery | null {
  if (found.entries.length === 0 && found.tip === null) return null;
  const base = fileOf(found.base.text);
  if (base === null) return null;
  const start = found.tip === null ? base : fileOf(found.tip.text);
  const first = found.tip === null ? (found.entries[0]?.number ?? 0) : found.tip.number + 1;
  const { files, labels } = start === null ? { files: [], labels: [] } : replay(start, first, found.entries);
  const lost = found.entries.length - labels.length + (start === null ? 1 : 0);
  const file = files.at(-1) ?? start ?? base;
  // a save may have been cut off after any step, so each state may be this level's own version on disk
  const isFile = (read: LevelFile | null) => read !== null;
  const sent = [...(found.base.sent ?? []).map(fileOf), found.tip === null ? null : start, ...files].filter(isFile);
  return { base: { file: base, etag: found.base.etag, sent }, file, labels, time: found.time, lost };
}
