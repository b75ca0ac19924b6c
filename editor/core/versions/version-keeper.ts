import { createStore, type StoreApi } from 'zustand/vanilla';
import type { EditedLevel } from '../document/index.ts';
import { isQuota } from '../journal/index.ts';
import { type LevelVersions, RecordedVersions } from './level-versions.ts';
import { createMemoryVersions, type Move, type VersionStore } from './version-store.ts';

/** Whether histories are kept, as the user sees it; null: they are. */
export type VersionTrouble = { readonly kind: 'missing' | 'failing'; readonly message: string } | null;

/** The histories of the levels that this page opens. */
export interface VersionKeeper {
  readonly trouble: StoreApi<VersionTrouble>;
  /** Follows the history of a level under a place: a name of the level in its folder. */
  follow(place: string, level: EditedLevel): LevelVersions;
  /** Levels got other places: they were renamed, deleted or restored. */
  moved(moves: readonly Move[]): void;
  /** Records at once what waits for an idle moment. */
  flush(): void;
  /** The browser's database answers after all: from now on histories are kept there. */
  adopt(store: VersionStore): void;
}

export interface VersionKeeperOptions {
  /** Where histories are kept; null if the browser has no database. */
  readonly store: VersionStore | null;
  /** ms since 1970 */
  readonly now: () => number;
  /** Calls back once the page is idle. @returns cancels it */
  readonly whenIdle: (call: () => void) => () => void;
}

const MISSING = {
  kind: 'missing',
  message: 'This browser stores no data for this page (a private window?), so the history lasts as long as this page.',
} as const;

/** What failed, and what to do. */
function troubleOf(error: unknown): NonNullable<VersionTrouble> {
  if (isQuota(error)) {
    const message = 'The browser has no room left: new versions are not added to the history. Free some space on the disk.';
    return { kind: 'failing', message };
  }
  const why = error instanceof Error ? error.message : String(error);
  return {
    kind: 'failing',
    message: `The browser could not read or keep the history: ${why}. It is tried again with each save.`,
  };
}

/** Keeps the histories of levels: each version that was on disk, and those with names. */
export function createVersionKeeper({ store, now, whenIdle }: VersionKeeperOptions): VersionKeeper {
  const passing = createMemoryVersions();
  let kept = store ?? passing;
  let isLasting = store !== null;
  const trouble = createStore<VersionTrouble>(() => (isLasting ? null : MISSING));
  // One queue for all levels and their moves: what was asked for before a move finds the history at its old place, what was
  // asked for after it at the new one.
  let last: Promise<unknown> = Promise.resolve();
  const inTurn = <T>(act: () => Promise<T>): Promise<T> => {
    const turn = last.then(act, act);
    last = turn;
    return turn;
  };
  const followed = new Set<LevelVersions>();
  const onStored = (error: unknown) => {
    const next = error === null ? (isLasting ? null : MISSING) : troubleOf(error);
    if (next?.message !== trouble.getState()?.message) trouble.setState(next, true);
  };
  return {
    trouble,
    follow(place, level) {
      const onClose = () => void followed.delete(versions);
      const parts = { store: () => kept, inTurn, now, whenIdle, onStored, onClose };
      const versions: LevelVersions = new RecordedVersions(place, level, parts);
      followed.add(versions);
      return versions;
    },
    moved(moves) {
      // what was noted belongs to the place that a level had
      for (const versions of followed) void versions.settled();
      void inTurn(() => kept.move(moves).then(() => onStored(null), onStored));
    },
    flush() {
      for (const versions of followed) void versions.settled();
    },
    adopt(found) {
      if (isLasting) return;
      isLasting = true;
      kept = found;
      onStored(null);
      // what this page has recorded until now
      void inTurn(() => passing.carryTo(found).catch(onStored));
      for (const versions of followed) void versions.settled();
    },
  };
}
