import { createStore, type StoreApi } from 'zustand/vanilla';
import type { EditedLevel } from '../document/index.ts';
import { failureOf, type JournalState } from './journal-state.ts';
import type { JournalStore } from './journal-store.ts';
import { type DiskState, keepLevel, type LevelJournal } from './level-journal.ts';
import { createMemoryStore } from './memory-store.ts';
import { type Recovery, recoveryOf } from './recovery.ts';

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
 * A journal of every step, so that nothing is lost when the page dies.
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
