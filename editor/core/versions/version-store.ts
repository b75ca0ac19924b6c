import { done, openDatabase } from '../database/index.ts';
import { fromStored, type StoredText, sizeOf, wholeText } from './stored-text.ts';
import { type Noted, VERSION_MAKERS, type Version } from './version.ts';

/** A version that gets its number when it is stored. */
export type NewVersion = Omit<Version, 'number' | 'base' | 'size'>;

/** A version that waits until it is recorded, and its key. */
export interface Waiting extends Noted {
  /** The history that it belongs to, negative: so it stands beside those of the history, and belongs to none yet. */
  readonly history: number;
  readonly number: number;
}

/** A history that goes to another place. */
export interface Move {
  readonly from: string;
  readonly to: string;
  /** Names this move, so that several pages that hear of it make it once. */
  readonly token: string;
}

/** What is stored of the text of a version: whatever is there, damaged or not. */
interface FoundTexts {
  readonly copies: readonly unknown[];
  readonly bases: readonly unknown[];
}

/** Where histories are kept. Each function is one transaction; its promise rejects when the database fails. */
export interface VersionStore {
  /** The number of the history at a place, which is begun if there is none. */
  open(place: string): Promise<number>;
  /** The versions of a history, oldest first. */
  list(history: number): Promise<readonly Version[]>;
  last(history: number): Promise<Version | null>;
  /** Takes what is to be recorded in a history. When this returns, nothing more is needed of the page. */
  handOver(history: number, noted: Noted): Promise<void>;
  /** What waits for a history, oldest first. */
  waiting(history: number): Promise<readonly Waiting[]>;
  forget(waiting: Waiting): Promise<void>;
  /**
   * Adds a version, unless the last one has the same text; if it has waited, unless it waits no longer.
   * @returns the new one, or the last one; null if the version that `text` is stored by is gone
   */
  add(history: number, version: NewVersion, text: StoredText, waiting?: Waiting | null): Promise<Version | null>;
  texts(history: number, version: Version): Promise<FoundTexts>;
  /** Removes versions and replaces others, except those that are no longer there. Texts that others are stored by stay. */
  change(history: number, drop: readonly number[], put: readonly Version[]): Promise<void>;
  /** Moves histories to other places, all at once. What is at a place that another history takes is set aside. */
  move(moves: readonly Move[]): Promise<void>;
}

/** The row of a place. */
export interface Head {
  readonly place: string;
  readonly history: number;
  /** The last move that brought the history here. */
  readonly token: string | null;
}

/** Where the history of a place goes that another history takes. */
const asideOf = ({ place, history }: Head): string => `${place}?aside ${history}`;

/** The heads after moves. @param heads by place; @returns the heads to delete and to put; null if the moves were made already */
export function movedHeads(
  heads: ReadonlyMap<string, Head>,
  moves: readonly Move[],
): { readonly gone: readonly string[]; readonly put: readonly Head[] } | null {
  const real = moves.filter(({ from, to }) => heads.has(from) && from !== to);
  if (real.length === 0 || moves.every(({ to, token }) => heads.get(to)?.token === token)) return null;
  const gone = new Set(real.map(({ from }) => from));
  const put: Head[] = [];
  for (const { from, to, token } of real) {
    const there = heads.get(to);
    if (there !== undefined && !gone.has(to)) put.push({ ...there, place: asideOf(there) });
    put.push({ place: to, history: (heads.get(from) as Head).history, token });
  }
  return { gone: [...gone], put };
}

/** The numbers of the texts that versions need. */
const neededTexts = (versions: readonly Version[]): ReadonlySet<number> =>
  new Set(versions.flatMap(({ number, base }) => [number, base]));

/** Tells versions apart that one page notes in the same ms. */
let turn = 0;

const waits = (history: number, noted: Noted): Waiting => ({
  ...noted,
  history: -history,
  number: 1000 * noted.time + (turn++ % 1000),
});

/** Whether a stored row is a waiting version, and not damaged. */
const isWaiting = ({ time, by, labels, text }: Waiting): boolean =>
  Number.isFinite(time) && VERSION_MAKERS.includes(by) && Array.isArray(labels) && typeof text === 'string';

interface Kept {
  versions: Version[];
  /** Copies by number. */
  readonly texts: Map<number, StoredText[]>;
}

/** Histories that live as long as the page. */
interface MemoryVersions extends VersionStore {
  /** Brings all of them to another store. */
  carryTo(store: VersionStore): Promise<void>;
}

/** Histories that live as long as the page, for browsers without a database. */
export function createMemoryVersions(): MemoryVersions {
  const heads = new Map<string, Head>();
  const histories = new Map<number, Kept>();
  let waiting: Waiting[] = [];
  const of = (history: number): Kept => histories.get(history) as Kept;
  const texts: VersionStore['texts'] = async (history, { number, base }) => ({
    copies: of(history).texts.get(number) ?? [],
    bases: of(history).texts.get(base) ?? [],
  });
  return {
    texts,
    async open(place) {
      const known = heads.get(place);
      if (known !== undefined) return known.history;
      const history = histories.size + 1;
      heads.set(place, { place, history, token: null });
      histories.set(history, { versions: [], texts: new Map() });
      return history;
    },
    list: async (history) => [...of(history).versions],
    last: async (history) => of(history).versions.at(-1) ?? null,
    async handOver(history, noted) {
      waiting.push(waits(history, noted));
    },
    waiting: async (history) => waiting.filter((one) => one.history === -history),
    async forget(one) {
      waiting = waiting.filter((other) => other !== one);
    },
    async add(history, version, text, from = null) {
      const kept = of(history);
      const last = kept.versions.at(-1);
      if (from !== null && !waiting.includes(from)) return last ?? null;
      const isNew = last?.check !== version.check;
      if (isNew && 'base' in text && !kept.texts.has(text.base)) return null;
      waiting = waiting.filter((other) => other !== from);
      if (!isNew) return last ?? null;
      const number = (last?.number ?? 0) + 1;
      const added: Version = { ...version, number, base: 'base' in text ? text.base : number, size: sizeOf(text) };
      kept.versions.push(added);
      kept.texts.set(number, 'whole' in text ? [text, text] : [text]);
      return added;
    },
    async change(history, drop, put) {
      const kept = of(history);
      const changed = new Map(put.map((version) => [version.number, version]));
      kept.versions = kept.versions
        .filter(({ number }) => !drop.includes(number))
        .map((version) => changed.get(version.number) ?? version);
      const needed = neededTexts(kept.versions);
      for (const number of [...kept.texts.keys()]) if (!needed.has(number)) kept.texts.delete(number);
    },
    async move(moves) {
      const moved = movedHeads(heads, moves);
      for (const place of moved?.gone ?? []) heads.delete(place);
      for (const head of moved?.put ?? []) heads.set(head.place, head);
    },
    async carryTo(store) {
      for (const [place, { history }] of heads) {
        const there = await store.open(place);
        for (const version of of(history).versions) {
          const { copies, bases } = await texts(history, version);
          const text = fromStored(copies, bases, version.check);
          if (text !== null) await store.add(there, version, wholeText(text));
        }
        for (const one of waiting) if (one.history === -history) await store.handOver(there, one);
      }
    },
  };
}

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
    handOver: (history, noted) =>
      database.within('readwrite', (stores) => {
        // two pages may note in the same ms: then the later one is refused, and keeps it
        stores(VERSIONS).add(waits(history, noted));
      }),
    waiting: (history) =>
      database.within('readonly', async (stores) =>
        ((await done(stores(VERSIONS).getAll(rowsOf(-history)))) as Waiting[]).filter(isWaiting),
      ),
    forget: (waiting) => database.within('readwrite', (stores) => forget(stores(VERSIONS), waiting)),
    add: (history, version, text, waiting = null) =>
      database.within('readwrite', async (stores) => {
        const [versions, texts] = [stores(VERSIONS), stores(TEXTS)];
        const last = await lastOf(versions, history);
        if (waiting !== null && (await done(versions.count([waiting.history, waiting.number]))) === 0) return last;
        const isNew = last?.check !== version.check;
        if (isNew && 'base' in text && (await done(texts.count(rowsOf(history, text.base)))) === 0) return null;
        if (waiting !== null) forget(versions, waiting);
        if (!isNew) return last;
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

function forget(versions: IDBObjectStore, { history, number }: Waiting): void {
  versions.delete([history, number]);
}

/** The number of what is kept for a place, a new one if there is none yet. @param heads the store of heads, within a transaction */
export async function historyAt(heads: IDBObjectStore, place: string): Promise<number> {
  const known = (await done(heads.get(place))) as Head | undefined;
  if (known !== undefined) return known.history;
  const all = (await done(heads.getAll())) as Head[];
  const history = all.reduce((most, head) => Math.max(most, head.history), 0) + 1;
  heads.put({ place, history, token: null } satisfies Head);
  return history;
}

/** Brings what is kept for places to other places. @param heads the store of heads, within a transaction */
export async function moveHeads(heads: IDBObjectStore, moves: readonly Move[]): Promise<void> {
  const places = [...new Set(moves.flatMap(({ from, to }) => [from, to]))];
  const found = (await Promise.all(places.map((place) => done(heads.get(place))))) as (Head | undefined)[];
  const moved = movedHeads(new Map(found.flatMap((head) => (head === undefined ? [] : [[head.place, head]]))), moves);
  for (const place of moved?.gone ?? []) heads.delete(place);
  for (const head of moved?.put ?? []) heads.put(head);
}
