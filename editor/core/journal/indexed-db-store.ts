import { done, openDatabase } from '../database/index.ts';
import type { JournalEntry, JournalStore, Kept } from './journal-store.ts';

const NAME = 'gravity-quest-editor-journal';
const HEADS = 'heads';
const ENTRIES = 'entries';

type Head = Omit<Kept, 'entries'>;
/** `time`: when it was kept, ms since 1970; older rows have none */
type Row = JournalEntry & { readonly place: string; readonly time?: number };

/** All entries of a place. In IndexedDB, numbers sort before arrays, so [] is an upper bound. */
const entriesOf = (place: string, upTo?: number) => IDBKeyRange.bound([place], [place, upTo ?? []]);

/**
 * The journal in the browser's database, which survives a crash of the page or the browser.
 * @param after calls back after `ms`; @returns cancels it
 * @throws (rejects) if the browser has no database or refuses it; waits for one that does not answer
 */
export async function openIndexedDbStore(
  databases: IDBFactory,
  after: (ms: number, call: () => void) => () => void,
): Promise<JournalStore> {
  const database = await openDatabase({
    databases,
    name: NAME,
    stores: { [HEADS]: 'place', [ENTRIES]: ['place', 'number'] },
    after,
  });

  return {
    write: ({ place, time, base, tip, dropUpTo, add }) =>
      database.within('readwrite', (stores, isChecked) => {
        const [heads, entries] = [stores(HEADS), stores(ENTRIES)];
        const putEntries = () => {
          if (dropUpTo !== undefined) entries.delete(entriesOf(place, dropUpTo));
          for (const entry of add) entries.put({ ...entry, place, time } satisfies Row);
        };
        const isWhole = base !== undefined && tip !== undefined;
        if (isWhole) heads.put({ place, time, base, tip } satisfies Head);
        if (isWhole || (!isChecked && base === undefined && tip === undefined)) return putEntries();
        return (async () => {
          const old = (await done(heads.get(place))) as Head | undefined;
          if (old === undefined)
            throw new DOMException('the start of the changes is gone: the data of this page was cleared', 'NotFoundError');
          heads.put({ ...old, time, base: base ?? old.base, tip: tip === undefined ? old.tip : tip } satisfies Head);
          putEntries();
        })();
      }),
    read: (place) =>
      database.within('readonly', async (stores) => {
        const rows = done(stores(ENTRIES).getAll(entriesOf(place)));
        const head = (await done(stores(HEADS).get(place))) as Head | undefined;
        const found = (await rows) as Row[];
        if (head === undefined) return null;
        const entries = found.map(({ place: _, time: __, ...entry }) => entry);
        return { ...head, time: Math.max(head.time, found.at(-1)?.time ?? 0), entries };
      }),
    places: () =>
      database.within('readonly', async (stores) => {
        const heads = (await done(stores(HEADS).getAll())) as Head[];
        return Promise.all(
          heads.map(async ({ place, time }) => {
            const range = entriesOf(place);
            const [entries, last] = await Promise.all([
              done(stores(ENTRIES).count(range)),
              done(stores(ENTRIES).openCursor(range, 'prev')),
            ]);
            return { place, time: Math.max(time, (last?.value as Row | undefined)?.time ?? 0), entries };
          }),
        );
      }),
    remove: (place) =>
      database.within('readwrite', (stores) => {
        stores(HEADS).delete(place);
        stores(ENTRIES).delete(entriesOf(place));
      }),
  };
}
