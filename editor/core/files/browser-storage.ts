import type { EditEvent } from '../../../schema/index.ts';
import { type Answer, type LevelStorage, type StorageError, storageError } from './level-storage.ts';
import {
  duplicateLevel,
  EMPTY,
  entryOf,
  listOf,
  mustExist,
  orderLevels,
  Refused,
  removeLevel,
  renameLevel,
  restoreLevel,
  type Shelf,
  type ShelfChange,
  writeLevel,
  writePack,
} from './shelf.ts';
import type { Channel } from './writer-lock.ts';

/** A key-value database; `update` reads and writes in one transaction, so that two pages can't interfere. */
export interface KeyValues {
  get(key: string): Promise<unknown>;
  update(key: string, change: (old: unknown) => unknown): Promise<void>;
}

const KEY = 'gravity-quest-editor-levels';

/**
 * Levels in this browser's own database, for a page that comes from a plain web server.
 * @param channel tells other pages of this browser what has changed; null if there is none
 * @param now ms since 1970
 * @param lasts whether the database outlives the page
 */
export function createBrowserStorage(
  database: KeyValues,
  channel: Channel | null,
  now: () => number,
  lasts = true,
): LevelStorage {
  const shelfOf = (value: unknown): Shelf => (value as Shelf | undefined) ?? EMPTY;
  const look = async <T>(pick: (shelf: Shelf) => T): Promise<Answer<T>> => {
    try {
      return { ok: true, value: pick(shelfOf(await database.get(KEY))) };
    } catch (error) {
      return { ok: false, error: failure(error) };
    }
  };
  /** Changes the shelf in one transaction. */
  const change = async <T>(act: (shelf: Shelf) => ShelfChange<T>): Promise<Answer<T>> => {
    try {
      let done: { value: T; event: EditEvent } | null = null;
      // an exception thrown within an update might get lost
      let refused: unknown = null;
      await database.update(KEY, (old) => {
        refused = null;
        try {
          const { shelf, ...rest } = act(shelfOf(old));
          done = rest;
          return shelf;
        } catch (error) {
          refused = error;
          return old;
        }
      });
      if (refused !== null || done === null) throw refused;
      const { value, event } = done as { value: T; event: EditEvent };
      channel?.postMessage(event);
      return { ok: true, value };
    } catch (error) {
      return { ok: false, error: failure(error) };
    }
  };
  return {
    kind: 'browser',
    lasts,
    list: () => look(listOf),
    read: (id) =>
      look((shelf) => {
        const level = mustExist(shelf, id);
        return { ...entryOf(id, level), text: level.text };
      }),
    write: (id, text, base) => change((shelf) => writeLevel(shelf, id, text, base)),
    rename: (id, to, base) => change((shelf) => renameLevel(shelf, id, to, base)),
    duplicate: (id, to, base) => change((shelf) => duplicateLevel(shelf, id, to, base)),
    remove: (id, base) => change((shelf) => removeLevel(shelf, id, base, now())),
    trash: () => look(({ trash }) => trash.map(({ text: _, ...entry }) => entry)),
    restore: (name, to) => change((shelf) => restoreLevel(shelf, name, to)),
    order: (_, ids) => change((shelf) => orderLevels(shelf, ids)),
    writePack: (text, base) => change((shelf) => writePack(shelf, text, base)),
    publish: null,
    watch(onEvent, onLink) {
      let isOver = false;
      channel?.addEventListener('message', ({ data }) => {
        if (!isOver) onEvent(data as EditEvent);
      });
      onLink('up');
      void look(listOf).then((answer) => {
        if (!isOver && answer.ok) onEvent({ type: 'list', list: answer.value });
      });
      return () => {
        isOver = true;
      };
    },
  };
}

/** Why a request failed. */
function failure(error: unknown): StorageError {
  if (error instanceof Refused) return error.error;
  const isFull = error instanceof Error && error.name === 'QuotaExceededError';
  const message = isFull
    ? 'the browser has no room left for levels'
    : `the browser's database fails: ${error instanceof Error ? error.message : error}`;
  return storageError(isFull ? 'disk-full' : 'failed', message, 'download the level, so that it is not lost');
}
