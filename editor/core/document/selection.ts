import { createStore, type StoreApi } from 'zustand/vanilla';
import { isSame } from '../../../schema/index.ts';
import type { EditedLevel } from './edited-level.ts';
import { grabbableIn } from './marks.ts';
import { type ObjectKey, objectsOf } from './objects.ts';

/** The selection, which is neither saved nor part of the history. */
export interface Selection {
  /** In order of selection; all of them exist. */
  readonly keys: readonly ObjectKey[];
  /** Selected holds: indices into the run's holds as `holdsOf` returns them. */
  readonly holds: readonly number[];
  /** The run of the selected holds; null if no hold is selected. */
  readonly run: string | null;
}

export interface SelectionStore {
  readonly store: StoreApi<Selection>;
  keys(): readonly ObjectKey[];
  /** Selects exactly these objects; missing ones are skipped. Holds are deselected. */
  select(keys: Iterable<ObjectKey>): void;
  add(keys: Iterable<ObjectKey>): void;
  /** Removes objects from the selection if all of them are selected, else adds them. */
  toggle(keys: readonly ObjectKey[]): void;
  /** Selects all objects that are neither locked nor hidden. */
  selectAll(): void;
  selectHolds(run: string, holds: Iterable<number>): void;
  clear(): void;
  /** Stops following the level. */
  close(): void;
}

const NONE: Selection = { keys: [], holds: [], run: null };

/** A selection in a level. Objects, runs and holds that disappear are deselected. */
export function createSelection(level: EditedLevel): SelectionStore {
  const store = createStore<Selection>(() => NONE);
  /** A drag selects what it drags at every step: nobody is told about what is selected already. */
  const set = (next: Selection) => {
    if (!isSame(store.getState(), next)) store.setState(next, true);
  };
  const existing = (keys: Iterable<ObjectKey>): ObjectKey[] => {
    const objects = objectsOf(level.file());
    return [...new Set(keys)].filter((key) => objects.has(key));
  };
  const keys = () => store.getState().keys;

  const dropMissing = () => {
    const { keys, holds, run } = store.getState();
    const objects = objectsOf(level.file());
    const kept = keys.filter((key) => objects.has(key));
    const length = run === null ? 0 : (level.file().runs?.find(({ name }) => name === run)?.holds.length ?? 0);
    const left = holds.filter((hold) => hold < length);
    if (kept.length === keys.length && left.length === holds.length) return;
    set({ keys: kept, holds: left, run: left.length === 0 ? null : run });
  };

  return {
    store,
    keys,
    select: (wanted) => set({ ...NONE, keys: existing(wanted) }),
    add: (more) => set({ ...NONE, keys: existing([...keys(), ...more]) }),
    toggle(wanted) {
      const old = new Set(keys());
      const all = wanted.every((key) => old.has(key));
      set({ ...NONE, keys: all ? keys().filter((key) => !wanted.includes(key)) : existing([...keys(), ...wanted]) });
    },
    selectAll: () => set({ ...NONE, keys: [...grabbableIn(level.file()).keys()] }),
    selectHolds(run, holds) {
      const chosen = [...new Set(holds)].sort((a, b) => a - b);
      set({ keys: [], holds: chosen, run: chosen.length === 0 ? null : run });
      dropMissing();
    },
    clear: () => set(NONE),
    close: level.subscribe(dropMissing),
  };
}
