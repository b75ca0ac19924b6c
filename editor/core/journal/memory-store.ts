import type { JournalStore, Kept } from './journal-store.ts';

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
