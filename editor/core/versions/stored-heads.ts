import { done } from '../database/index.ts';
import { type Head, type Move, movedHeads } from './version-store.ts';

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
