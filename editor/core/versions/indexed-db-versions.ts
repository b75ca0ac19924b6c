import { done, openDatabase } from '../database/index.ts';
import { historyAt, moveHeads } from './stored-heads.ts';
import { type StoredText, sizeOf } from './stored-text.ts';
import type { Version } from './version.ts';
import { neededTexts, type VersionStore } from './version-store.ts';

const NAME = 'gravity-quest-editor-versions';
const HEADS = 'heads';
const VERSIONS = 'versions';
const TEXTS = 'texts';

type VersionRow = Version & { readonly history: number };
/** `copy`: whole texts are stored twice */
type TextRow = StoredText & { readonly history: number; readonly number: number; readonly copy: 0 | 1 };

/** All rows of a history, or of one of its numbers. In IndexedDB, numbers sort before arrays, so [] is an upper bound. */
const rowsOf = (...key: readonly number[]) => IDBKeyRange.bound([...key], [...key, []]);

const versionOf = ({ history: _, ...version }: VersionRow): Version => version;

/** The last version of a history, within a transaction. */
async function lastOf(versions: IDBObjectStore, history: number): Promise<Version | null> {
  const cursor = await done(versions.openCursor(rowsOf(history), 'prev'));
  if (cursor === null) return null;
  // the key is whole even if the row is damaged
  const [, number] = cursor.key as [number, number];
  return { ...versionOf(cursor.value as VersionRow), number };
}

/**
 * Histories in the browser's database.
 * @param after calls back after `ms`; @returns cancels it
 * @throws (rejects) if the browser has no database or refuses it; waits for one that does not answer
 */
export async function openIndexedDbVersions(
  databases: IDBFactory,
  after: (ms: number, call: () => void) => () => void,
): Promise<VersionStore> {
  const database = await openDatabase({
    databases,
    name: NAME,
    stores: { [HEADS]: 'place', [VERSIONS]: ['history', 'number'], [TEXTS]: ['history', 'number', 'copy'] },
    after,
  });

  return {
    open: (place) => database.within('readwrite', (stores) => historyAt(stores(HEADS), place)),
    list: (history) =>
      database.within('readonly', async (stores) =>
        ((await done(stores(VERSIONS).getAll(rowsOf(history)))) as VersionRow[]).map(versionOf),
      ),
    last: (history) => database.within('readonly', (stores) => lastOf(stores(VERSIONS), history)),
    add: (history, version, text) =>
      database.within('readwrite', async (stores) => {
        const [versions, texts] = [stores(VERSIONS), stores(TEXTS)];
        const last = await lastOf(versions, history);
        if (last?.check === version.check) return last;
        if ('base' in text && (await done(texts.count(rowsOf(history, text.base)))) === 0) return null;
        const number = (last?.number ?? 0) + 1;
        const added: Version = { ...version, number, base: 'base' in text ? text.base : number, size: sizeOf(text) };
        versions.put({ ...added, history } satisfies VersionRow);
        texts.put({ ...text, history, number, copy: 0 } satisfies TextRow);
        if ('whole' in text) texts.put({ ...text, history, number, copy: 1 } satisfies TextRow);
        return added;
      }),
    texts: (history, { number, base }) =>
      database.within('readonly', async (stores) => {
        const texts = stores(TEXTS);
        const [copies, bases] = await Promise.all([
          done(texts.getAll(rowsOf(history, number))),
          done(texts.getAll(rowsOf(history, base))),
        ]);
        return { copies, bases };
      }),
    change: (history, drop, put) =>
      database.within('readwrite', async (stores) => {
        const [versions, texts] = [stores(VERSIONS), stores(TEXTS)];
        const there = (await done(versions.getAllKeys(rowsOf(history)))) as [number, number][];
        const numbers = new Set(there.map(([, number]) => number));
        for (const version of put) if (numbers.has(version.number)) versions.put({ ...version, history } satisfies VersionRow);
        for (const number of drop) versions.delete([history, number]);
        const kept = ((await done(versions.getAll(rowsOf(history)))) as VersionRow[]).map(versionOf);
        const needed = neededTexts(kept);
        for (const key of (await done(texts.getAllKeys(rowsOf(history)))) as [number, number, number][]) {
          if (!needed.has(key[1])) texts.delete(key);
        }
      }),
    move: (moves) => database.within('readwrite', (stores) => moveHeads(stores(HEADS), moves)),
  };
}
