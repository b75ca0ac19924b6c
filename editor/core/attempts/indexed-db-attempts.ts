import { done, openDatabase } from '../database/index.ts';
import { historyAt, moveHeads } from '../versions/index.ts';
import type { AttemptStore } from './attempt-store.ts';
import type { Attempt } from './attempts.ts';

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
