import { type StoredText, sizeOf } from './stored-text.ts';
import type { Version } from './version.ts';
import { type Head, movedHeads, neededTexts, type VersionStore } from './version-store.ts';

interface Kept {
  versions: Version[];
  /** Copies by number. */
  readonly texts: Map<number, StoredText[]>;
}

/** Histories that live as long as the page, for browsers without a database. */
export function createMemoryVersions(): VersionStore {
  const heads = new Map<string, Head>();
  const histories = new Map<number, Kept>();
  const of = (history: number): Kept => histories.get(history) as Kept;
  return {
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
    async add(history, version, text) {
      const kept = of(history);
      const last = kept.versions.at(-1);
      if (last?.check === version.check) return last;
      if ('base' in text && !kept.texts.has(text.base)) return null;
      const number = (last?.number ?? 0) + 1;
      const added: Version = { ...version, number, base: 'base' in text ? text.base : number, size: sizeOf(text) };
      kept.versions.push(added);
      kept.texts.set(number, 'whole' in text ? [text, text] : [text]);
      return added;
    },
    async texts(history, { number, base }) {
      const { texts } = of(history);
      return { copies: texts.get(number) ?? [], bases: texts.get(base) ?? [] };
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
  };
}
