import { createHash } from 'node:crypto';
import { setImmediate } from 'node:timers/promises';
import type { EditEvent, LevelEntry, ListResponse } from '../../schema/index.ts';
import { systemReason } from '../failure.ts';
import { schemaReference } from '../schema-reference.ts';
import { changesBetween } from './changes.ts';
import { findLevel, findLevels, inOrderOfPlay, type LevelFileFound } from './level-files.ts';
import type { EntryReader } from './read-entry.ts';

/** What has been reported of a folder to everybody, kept the same as the disk. */
export interface KnownLevels {
  /** What is known now. */
  list(): ListResponse;
  /** Looks at the whole folder and announces what other programs have changed. @returns the list as it is then; what is known while it is read for the first time */
  refresh(): Promise<ListResponse>;
  /** Looks at some files alone and announces what `by` has done to them; null: another program. */
  announce(ids: readonly string[], by: string | null): void;
  /** Tells what goes on from now on. @returns how to end it */
  listen(listener: (event: EditEvent) => void): () => void;
  /** Something about the folder that a person should know from now on. */
  addTrouble(message: string): void;
  /** Reads no further. */
  end(): void;
}

/** So many files are read before anybody asks; of larger folders the rest is reported as it is read. */
const READ_AT_ONCE = 500;

/** Levels that are reported together while a folder is read for the first time. */
const TOLD_TOGETHER = 1000;

/** How long the disk is read before others get their turn, ms. */
const SLICE = 20;

/** Of more files than this the whole folder is looked at. */
const FEW = 20;

export function createKnownLevels(root: string, shown: string, reader: EntryReader): KnownLevels {
  const listeners = new Set<(event: EditEvent) => void>();
  const troubles: string[] = [];
  const folder = {
    id: createHash('sha256').update(root).digest('hex').slice(0, 16),
    path: shown,
    $schema: schemaReference(root),
  };

  const first = findLevels(root);
  const files = [...first.files.values()];
  let folders = first.folders;
  let lookTroubles = first.troubles;
  /** In the order of play. */
  let levels: LevelEntry[] = files.slice(0, READ_AT_ONCE).map((file) => reader.entry(file));
  let unread = files.length - levels.length;
  let isOver = false;
  /** Ids that were announced during a look at the whole folder, which may have seen them before that. */
  let announced = new Set<string>();

  const tell = (event: EditEvent): void => {
    for (const listener of listeners) {
      try {
        listener(event);
      } catch {
        // who can't hear any more is nobody else's business, least of all of who has just written
        listeners.delete(listener);
      }
    }
  };

  const list = (): ListResponse => ({
    folder,
    folders: [...folders],
    levels: [...levels],
    troubles: [...troubles, ...lookTroubles],
    unread,
  });

  /** Where an id is in the list, or belongs. */
  const placeOf = (id: string): number => {
    let [low, high] = [0, levels.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (inOrderOfPlay(levels[middle].id, id) < 0) low = middle + 1;
      else high = middle;
    }
    return low;
  };

  const put = (entry: LevelEntry): void => {
    const last = levels.at(-1);
    const place = last === undefined || inOrderOfPlay(last.id, entry.id) < 0 ? levels.length : placeOf(entry.id);
    levels.splice(place, levels[place]?.id === entry.id ? 1 : 0, entry);
  };

  /** Reads what is left of a large folder, bit by bit. */
  const readRest = async (rest: readonly LevelFileFound[]): Promise<void> => {
    let together: LevelEntry[] = [];
    let since = performance.now();
    for (const [i, file] of rest.entries()) {
      if (isOver) return;
      together.push(reader.entry(file));
      if (together.length >= TOLD_TOGETHER || i === rest.length - 1) {
        // one that was made or changed meanwhile is known already
        const news = together.filter(({ id }) => levels[placeOf(id)]?.id !== id);
        for (const entry of news) put(entry);
        unread = rest.length - 1 - i;
        tell({ type: 'read', levels: news, unread });
        together = [];
      }
      if (performance.now() - since < SLICE) continue;
      await setImmediate();
      since = performance.now();
    }
    await refresh();
  };

  const lookAtAll = async (): Promise<void> => {
    if (unread > 0 || isOver) return;
    announced = new Set();
    const found = findLevels(root);
    const seen: LevelEntry[] = [];
    let since = performance.now();
    for (const file of found.files.values()) {
      seen.push(reader.entry(file));
      if (performance.now() - since < SLICE) continue;
      await setImmediate();
      since = performance.now();
    }
    const before = list();
    const now = announced.size === 0 ? seen : seen.filter(({ id }) => !announced.has(id));
    levels = now;
    if (announced.size > 0) for (const entry of before.levels) if (announced.has(entry.id)) put(entry);
    reader.keepOnly(levels);
    folders = found.folders;
    lookTroubles = found.troubles;
    for (const event of changesBetween(before, list(), null)) tell(event);
  };

  let current: Promise<void> = Promise.resolve();
  let next: Promise<void> | null = null;
  // who asks while a look goes on is told of the next one, which begins after the question
  const refresh = async (): Promise<ListResponse> => {
    next ??= current.then(() => {
      next = null;
      const look = lookAtAll();
      // one that fails is its asker's business, and not that of the next
      current = look.catch(() => {});
      return look;
    });
    await next;
    return list();
  };

  const announce = (ids: readonly string[], by: string | null): void => {
    const all = ids.length > FEW ? findLevels(root).files : null;
    const before: LevelEntry[] = [];
    const after: LevelEntry[] = [];
    for (const id of new Set(ids)) {
      announced.add(id);
      const place = placeOf(id);
      const old = levels[place]?.id === id ? levels[place] : undefined;
      if (old !== undefined) before.push(old);
      const file = all === null ? findLevel(root, id) : all.get(id);
      const entry = file === undefined ? undefined : reader.entry(file);
      if (entry !== undefined) after.push(entry);
      if (entry !== undefined) put(entry);
      else if (old !== undefined) levels.splice(place, 1);
    }
    const rest = list();
    for (const event of changesBetween({ ...rest, levels: before }, { ...rest, levels: after }, by)) tell(event);
  };

  const listen = (listener: (event: EditEvent) => void): (() => void) => {
    listeners.add(listener);
    return () => listeners.delete(listener);
  };

  const addTrouble = (message: string): void => {
    if (troubles.includes(message)) return;
    troubles.push(message);
    tell({ type: 'list', list: list() });
  };

  if (unread > 0) {
    setImmediate()
      .then(() => readRest(files.slice(READ_AT_ONCE)))
      .catch((error) => addTrouble(`the folder could not be read to its end: ${systemReason(error)}`));
  }
  const end = (): void => {
    isOver = true;
  };
  return { list, refresh, announce, listen, addTrouble, end };
}
