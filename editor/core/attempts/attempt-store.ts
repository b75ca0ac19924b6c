import { done, openDatabase } from '../database/index.ts';
import { type Head, historyAt, type Move, movedHeads, moveHeads } from '../versions/index.ts';
import type { Attempt } from './attempts.ts';

/**
 * Where attempts are kept. The attempts at a level are a list with a number, which goes with the level to other places. Each function
 * is one transaction; its promise rejects when the database fails.
 */
export interface AttemptStore {
  /** The number of the list at a place, which is begun if there is none. */
  open(place: string): Promise<number>;
  attempts(list: number): Promise<readonly Attempt[]>;
  put(list: number, attempts: readonly Attempt[]): Promise<void>;
  remove(list: number, ids: readonly string[]): Promise<void>;
  /** Moves lists to other places, all at once. What is at a place that another list takes is set aside. */
  move(moves: readonly Move[]): Promise<void>;
}

/** Attempts that live as long as the page, for browsers without a database. */
export function createMemoryAttempts(): AttemptStore {
  const heads = new Map<string, Head>();
  const lists = new Map<number, Map<string, Attempt>>();
  const of = (list: number): Map<string, Attempt> => lists.get(list) as Map<string, Attempt>;
  return {
    async open(place) {
      const known = heads.get(place);
      if (known !== undefined) return known.history;
      const list = lists.size + 1;
      heads.set(place, { place, history: list, token: null });
      lists.set(list, new Map());
      return list;
    },
    attempts: async (list) => [...of(list).values()],
    async put(list, attempts) {
      for (const attempt of attempts) of(list).set(attempt.id, attempt);
    },
    async remove(list, ids) {
      for (const id of ids) of(list).delete(id);
    },
    async move(moves) {
      const moved = movedHeads(heads, moves);
      for (const place of moved?.gone ?? []) heads.delete(place);
      for (const head of moved?.put ?? []) heads.set(head.place, head);
    },
  };
}

const NAME = 'gravity-quest-editor-attempts';
const HEADS = 'heads';
const ATTEMPTS = 'attempts';

type Row = Attempt & { readonly list: number };

/** All rows of a list. In IndexedDB, strings sort before arrays, so [] is an upper bound. */
const rowsOf = (list: number) => IDBKeyRange.bound([list], [list, []]);

/**
 * Attempts in the browser's database.
 * @param after calls back after `ms`; @returns cancels it
 * @throws (rejects) if the browser has no database or refuses it; waits for one that does not answer
 */
export async function openIndexedDbAttempts(
  databases: IDBFactory,
  after: (ms: number, call: () => void) => () => void,
): Promise<AttemptStore> {
  const stores = { [HEADS]: 'place', [ATTEMPTS]: ['list', 'id'] };
  const database = await openDatabase({ databases, name: NAME, stores, after });
  return {
    open: (place) => database.within('readwrite', (store) => historyAt(store(HEADS), place)),
    attempts: (list) =>
      database.within('readonly', async (store) =>
        ((await done(store(ATTEMPTS).getAll(rowsOf(list)))) as Row[]).map(({ list: _, ...attempt }) => attempt),
      ),
    // handed over at once: the page may be reloaded right after it
    put: (list, attempts) =>
      database.within('readwrite', (store) => {
        for (const attempt of attempts) store(ATTEMPTS).put({ ...attempt, list } satisfies Row);
      }),
    remove: (list, ids) =>
      database.within('readwrite', (store) => {
        for (const id of ids) store(ATTEMPTS).delete([list, id]);
      }),
    move: (moves) => database.within('readwrite', (store) => moveHeads(store(HEADS), moves)),
  };
}
