import { createStore, type StoreApi } from 'zustand/vanilla';
import type { EditedLevel } from '../document/index.ts';
import { failureOf, type JournalState } from './journal-state.ts';
import type { JournalStore } from './journal-store.ts';
import { type DiskState, keepLevel, type LevelJournal } from './level-journal.ts';
import { createMemoryStore } from './memory-store.ts';
import { type Recovery, recoveryOf } from './recovery.ts';

export interface Journal {
  readonly state: StoreApi<JournalState>;
  /** The browser has a database after all: whoever follows a level recovers what it has, and follows anew. */
  adopt(store: JournalStore): void;
  /** Calls back when that has happened. @returns stops it */
  onAdopted(listener: () => void): () => void;
  /** What was left of a level; null when all of it reached the disk. Rejects when the database fails. */
  recover(place: string): Promise<Recovery | null>;
  /** All levels with changes that never reached the disk. Rejects when the database fails. */
  unsaved(): Promise<readonly { readonly place: string; readonly time: number }[]>;
  /**
   * Keeps every step of a level under a place, a name of the level in its folder.
   * What was kept of it before is replaced by what the level is now, so recover first.
   * @param base what is on the disk, or what of `sent`
   */
  follow(place: string, level: EditedLevel, base: DiskState): LevelJournal;
  /** Forgets a level: the person has thrown its changes away. */
  forget(place: string): Promise<void>;
}

/** What is said where the page has no database. */
const MISSING = {
  message: 'this browser keeps no data of the page (a private window?), so changes that are not saved are lost with it',
  hint: 'download the level from time to time, or open the editor in an ordinary window',
};

/**
 * A journal of every step, so that a page that dies loses nothing.
 * @param store where it is kept; null where the browser has no database: then it says so, and keeps for as long as the page lives
 * @param now ms since 1970
 * @param after calls back after so many ms, and gives what takes the request back; null: a write that failed is tried with the next change alone
 * @param missing what is said where there is no store
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
      // what is followed stays where it began: who adopts another store follows anew
      keepLevel(place, level, base, { store: kept, isLasting, state, now, after, freeRoom }),
  };
}
