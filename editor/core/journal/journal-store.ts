import { done, openDatabase } from '../database/index.ts';
import type { Patch } from '../document/index.ts';

/** One step of one level. */
export interface JournalEntry {
  /** counts up within a level, without gaps */
  readonly number: number;
  readonly label: string;
  readonly patches: readonly Patch[];
}

/** The text of a level and its etag on disk; null if it never was on disk. */
export interface JournalBase {
  readonly text: string;
  readonly etag: string | null;
  /** Texts that were sent since and not answered. None if absent. */
  readonly sent?: readonly string[];
}

/** The data of one level. */
export interface Kept {
  readonly place: string;
  /** The state on disk when the entries began. */
  readonly base: JournalBase;
  /** The level after entry `number`, if earlier entries were merged into one text. */
  readonly tip: { readonly text: string; readonly number: number } | null;
  /** in order */
  readonly entries: readonly JournalEntry[];
  /** when something was last kept, ms since 1970 */
  readonly time: number;
}

/** A change of the data of one level; atomic. */
export interface JournalWrite {
  readonly place: string;
  readonly time: number;
  readonly base?: JournalBase;
  readonly tip?: Kept['tip'];
  /** Entries up to this number are no longer needed. */
  readonly dropUpTo?: number;
  readonly add: readonly JournalEntry[];
}

/** Where the journal is kept. Every promise rejects when the database fails; then nothing is changed. */
export interface JournalStore {
  write(change: JournalWrite): Promise<void>;
  read(place: string): Promise<Kept | null>;
  places(): Promise<readonly { readonly place: string; readonly time: number; readonly entries: number }[]>;
  /** Deletes the data of a level. */
  remove(place: string): Promise<void>;
}

/** Applies a write to what was kept; defines the meaning of `JournalWrite`. */
function written(old: Kept | undefined, { place, time, base, tip, dropUpTo, add }: Parameters<JournalStore['write']>[0]): Kept {
  const kept = (old?.entries ?? []).filter(({ number }) => dropUpTo === undefined || number > dropUpTo);
  return {
    place,
    time,
    base: base ?? old?.base ?? { text: '', etag: null },
    tip: tip === undefined ? (old?.tip ?? null) : tip,
    entries: [...kept, ...add],
  };
}

/** A journal that lives as long as the page, for browsers without a database. */
export function createMemoryStore(): JournalStore {
  const kept = new Map<string, Kept>();
  return {
    async write(change) {
      kept.set(change.place, written(kept.get(change.place), change));
    },
    read: async (place) => kept.get(place) ?? null,
    places: async () => [...kept.values()].map(({ place, time, entries }) => ({ place, time, entries: entries.length })),
    async remove(place) {
      kept.delete(place);
    },
  };
}

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

/** Whether work is kept, as the user sees it. */
export type JournalState =
  | { readonly kind: 'working' }
  /** nothing outlives this page */
  | { readonly kind: 'missing'; readonly message: string; readonly hint: string }
  /** the last changes could not be kept; retried with every change */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string };

/** Whether the database is full. */
export const isQuota = (error: unknown): boolean => error instanceof Error && error.name === 'QuotaExceededError';

/** The state of the journal after a failure of its database. */
export function failureOf(error: unknown): JournalState {
  if (isQuota(error)) {
    return {
      kind: 'failing',
      message: 'the browser has no room left to keep your changes until they are saved',
      hint: 'save the level, free some space on the disk, or clear the data of other sites',
    };
  }
  const why = error instanceof Error ? error.message : String(error);
  return {
    kind: 'failing',
    message: `the browser could not keep your changes until they are saved: ${why}`,
    hint: 'save the level now',
  };
}
