import type { JournalEntry, JournalStore, Kept } from './journal-store.ts';

const NAME = 'gravity-quest-editor-journal';
const HEADS = 'heads';
const ENTRIES = 'entries';

type Head = Omit<Kept, 'entries'>;
type Row = JournalEntry & { readonly place: string };

const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

const finished = (transaction: IDBTransaction): Promise<void> =>
  new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new DOMException('the transaction was aborted', 'AbortError'));
    transaction.onerror = () => reject(transaction.error);
  });

function open(databases: IDBFactory): Promise<IDBDatabase> {
  const request = databases.open(NAME, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(HEADS, { keyPath: 'place' });
    request.result.createObjectStore(ENTRIES, { keyPath: ['place', 'number'] });
  };
  return done(request);
}

/** All entries of a place: numbers sort before [] does. */
const entriesOf = (place: string, upTo?: number) => IDBKeyRange.bound([place], [place, upTo ?? []]);

/**
 * The journal in the browser's database: what was kept is there after a crash of the page or the browser.
 * @throws (rejects) when the browser has no database or refuses it
 */
export async function openIndexedDbStore(databases: IDBFactory): Promise<JournalStore> {
  let database = await open(databases);

  /** Runs in one transaction; once more on a new connection when the browser had closed the last one. */
  const within = async <T>(
    mode: IDBTransactionMode,
    work: (heads: IDBObjectStore, entries: IDBObjectStore) => Promise<T>,
  ): Promise<T> => {
    const begin = () => database.transaction([HEADS, ENTRIES], mode, { durability: 'strict' });
    let transaction: IDBTransaction;
    try {
      transaction = begin();
    } catch (error) {
      if (!(error instanceof DOMException) || error.name !== 'InvalidStateError') throw error;
      database = await open(databases);
      transaction = begin();
    }
    const end = finished(transaction);
    // the reason is told by the work or by the end, whichever comes first
    end.catch(() => undefined);
    const result = await work(transaction.objectStore(HEADS), transaction.objectStore(ENTRIES));
    await end;
    return result;
  };

  return {
    write: ({ place, time, base, tip, dropUpTo, add }) =>
      within('readwrite', async (heads, entries) => {
        const old = (await done(heads.get(place))) as Head | undefined;
        const head: Head = {
          place,
          time,
          base: base ?? old?.base ?? { text: '', etag: null },
          tip: tip === undefined ? (old?.tip ?? null) : tip,
        };
        heads.put(head);
        if (dropUpTo !== undefined) entries.delete(entriesOf(place, dropUpTo));
        for (const entry of add) entries.put({ ...entry, place } satisfies Row);
      }),
    read: (place) =>
      within('readonly', async (heads, entries) => {
        const rows = done(entries.getAll(entriesOf(place)));
        const head = (await done(heads.get(place))) as Head | undefined;
        const list = ((await rows) as Row[]).map(({ place: _, ...entry }) => entry);
        return head === undefined ? null : { ...head, entries: list };
      }),
    places: () =>
      within('readonly', async (heads, entries) => {
        const all = (await done(heads.getAll())) as Head[];
        const counts = await Promise.all(all.map(({ place }) => done(entries.count(entriesOf(place)))));
        return all.map(({ place, time }, i) => ({ place, time, entries: counts[i] }));
      }),
    remove: (place) =>
      within('readwrite', async (heads, entries) => {
        heads.delete(place);
        entries.delete(entriesOf(place));
      }),
  };
}
