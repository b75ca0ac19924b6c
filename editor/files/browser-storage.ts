import {
  type EditEvent,
  LEVEL_ID_PART,
  type LevelEntry,
  type ListResponse,
  type ReadResponse,
  type TrashEntry,
} from '../../schema/index.ts';
import { readText } from './disk-text.ts';
import { type Answer, type LevelStorage, type StorageError, storageError } from './level-storage.ts';
import type { Channel } from './writer-lock.ts';

/** A database of values by name; `update` reads and writes in one go, so that two pages can't both. */
export interface KeyValues {
  get(key: string): Promise<unknown>;
  update(key: string, change: (old: unknown) => unknown): Promise<void>;
}

interface StoredLevel {
  readonly text: string;
  /** Grows with every write: the etag. */
  readonly version: number;
}

interface Shelf {
  /** In the order of play; no object, which would put names that are numbers first. */
  readonly levels: ReadonlyMap<string, StoredLevel>;
  readonly trash: readonly (TrashEntry & { readonly text: string })[];
  /** The last version given. */
  readonly version: number;
}

const KEY = 'gravity-quest-editor-levels';
const EMPTY: Shelf = { levels: new Map(), trash: [], version: 0 };

const etagOf = ({ version }: StoredLevel): string => `"${version.toString(16).padStart(64, '0')}"`;

class Refused extends Error {
  constructor(readonly error: StorageError) {
    super(error.message);
  }
}

function entryOf(id: string, level: StoredLevel): LevelEntry {
  const reading = readText(level.text);
  return {
    id,
    file: `${id}.level.json`,
    etag: etagOf(level),
    status: reading.ok ? 'valid' : 'invalid',
    name: reading.ok ? reading.file.name : null,
    problems: reading.ok ? [] : [...reading.problems],
    readOnly: null,
  };
}

const listOf = ({ levels }: Shelf): ListResponse => ({
  folder: { id: 'this-browser', path: 'this browser', $schema: null },
  folders: [''],
  levels: [...levels].map(([id, level]) => entryOf(id, level)),
  troubles: [],
  unread: 0,
});

function mustExist(shelf: Shelf, id: string): StoredLevel {
  const level = shelf.levels.get(id);
  if (level !== undefined) return level;
  throw new Refused(
    storageError('unknown-level', `there is no level ${JSON.stringify(id)} in this browser`, 'it was deleted or renamed'),
  );
}

function mustFit(shelf: Shelf, id: string, base: string): StoredLevel {
  const level = mustExist(shelf, id);
  if (etagOf(level) === base) return level;
  const current: ReadResponse = { ...entryOf(id, level), text: level.text };
  throw new Refused(
    storageError('conflict', `${id} has changed since it was read`, 'bring the two versions together', { current }),
  );
}

function mustBeFree(shelf: Shelf, id: string): void {
  if (!LEVEL_ID_PART.test(id)) {
    throw new Refused(
      storageError('bad-name', `a level can't be called ${JSON.stringify(id)}`, 'use letters, digits, - _ and spaces inside'),
    );
  }
  if ([...shelf.levels.keys()].some((other) => other.toLowerCase() === id.toLowerCase())) {
    throw new Refused(storageError('name-taken', `there is a level ${JSON.stringify(id)} already`, 'choose another name'));
  }
}

const without = ({ levels }: Shelf, id: string) => new Map([...levels].filter(([name]) => name !== id));

/** Puts a level into the shelf: in the place of `at`, or at the end. */
function withLevel(shelf: Shelf, id: string, text: string, at: string | null = null): Shelf {
  const version = shelf.version + 1;
  const level = { text, version };
  const entries = [...shelf.levels];
  const levels =
    at === null ? [...entries, [id, level] as const] : entries.map((entry) => (entry[0] === at ? ([id, level] as const) : entry));
  return { ...shelf, levels: new Map(levels), version };
}

/**
 * Levels in this browser's own database: for a page that comes from a plain web server.
 * @param channel tells other pages of this browser what has changed; null where there is none
 * @param now ms since 1970
 * @param lasts whether what the database has is still there when the page is gone
 */
export function createBrowserStorage(
  database: KeyValues,
  channel: Channel | null,
  now: () => number,
  lasts = true,
): LevelStorage {
  const failure = (error: unknown): StorageError => {
    if (error instanceof Refused) return error.error;
    const isFull = error instanceof Error && error.name === 'QuotaExceededError';
    const message = isFull
      ? 'the browser has no room left for levels'
      : `the browser's database fails: ${error instanceof Error ? error.message : error}`;
    return storageError(isFull ? 'disk-full' : 'failed', message, 'download the level, so that it is not lost');
  };
  const shelfOf = (value: unknown): Shelf => (value as Shelf | undefined) ?? EMPTY;
  const look = async <T>(pick: (shelf: Shelf) => T): Promise<Answer<T>> => {
    try {
      return { ok: true, value: pick(shelfOf(await database.get(KEY))) };
    } catch (error) {
      return { ok: false, error: failure(error) };
    }
  };
  /** Changes the shelf in one go. */
  const change = async <T>(act: (shelf: Shelf) => { shelf: Shelf; value: T; event: EditEvent }): Promise<Answer<T>> => {
    try {
      let done: { value: T; event: EditEvent } | null = null;
      // what is thrown within an update may be lost on the way out
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
  const put = (shelf: Shelf, id: string, from: string | null = null) => {
    const entry = entryOf(id, mustExist(shelf, id));
    const event: EditEvent = from === null ? { type: 'changed', entry, by: null } : { type: 'renamed', from, entry, by: null };
    return { shelf, value: entry, event };
  };
  const mustBeValid = (text: string) => {
    const reading = readText(text);
    if (reading.ok) return;
    const problems = [...reading.problems];
    throw new Refused(storageError('invalid-level', problems[0].message, problems[0].hint, { problems }));
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
    write: (id, text, base) =>
      change((shelf) => {
        mustBeValid(text);
        if (base === null) mustBeFree(shelf, id);
        else mustFit(shelf, id, base);
        return put(withLevel(shelf, id, text, base === null ? null : id), id);
      }),
    rename: (id, to, base) =>
      change((shelf) => {
        const level = mustFit(shelf, id, base);
        mustBeFree({ ...shelf, levels: without(shelf, id) }, to);
        const levels = new Map([...shelf.levels].map(([name, other]) => (name === id ? [to, level] : [name, other])));
        return put({ ...shelf, levels }, to, id);
      }),
    duplicate: (id, to, base) =>
      change((shelf) => {
        mustBeFree(shelf, to);
        return put(withLevel(shelf, to, mustFit(shelf, id, base).text), to);
      }),
    remove: (id, base) =>
      change((shelf) => {
        const { text } = mustFit(shelf, id, base);
        const levels = without(shelf, id);
        const version = shelf.version + 1;
        const trashed: TrashEntry = { trash: `${id}~${version}`, id, deleted: new Date(now()).toISOString() };
        const trash = [{ ...trashed, text }, ...shelf.trash];
        return { shelf: { levels, trash, version }, value: { trashed }, event: { type: 'removed', id, by: null } };
      }),
    trash: () => look(({ trash }) => trash.map(({ text: _, ...entry }) => entry)),
    restore: (name, to) =>
      change((shelf) => {
        const found = shelf.trash.find(({ trash }) => trash === name);
        if (found === undefined)
          throw new Refused(storageError('unknown-level', 'it is not in the trash', 'it was restored already'));
        const id = to ?? found.id;
        mustBeFree(shelf, id);
        return put(withLevel({ ...shelf, trash: shelf.trash.filter((entry) => entry !== found) }, id, found.text), id);
      }),
    order: (_, ids) =>
      change((shelf) => {
        const all = [...shelf.levels.keys()];
        if (ids.length !== all.length || all.some((id) => !ids.includes(id))) {
          throw new Refused(storageError('list-changed', 'there are other levels now than in this order', 'look again'));
        }
        const ordered = { ...shelf, levels: new Map(ids.map((id) => [id, mustExist(shelf, id)])) };
        const list = listOf(ordered);
        return { shelf: ordered, value: { renamed: [], levels: list.levels }, event: { type: 'list', list } };
      }),
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
