import { createStore, type StoreApi } from 'zustand/vanilla';
import type { PlayStatistics, Attempt as Replayed } from '../../../check/plays/index.ts';
import { type Play, type PlayVerdict, playToText } from '../../../game/index.ts';
import type { Level } from '../../../schema/index.ts';
import { ofDocument } from '../kept/index.ts';
import { type DeathMap, deathMapOf } from './death-map.ts';

/** A play that was opened from outside, and what it turned out to be. */
export interface OpenedPlay {
  /** unique within the level */
  readonly key: string;
  /** Where it comes from: the name of its file, or what else it was. */
  readonly source: string;
  /** The content of its `.gqr` file. */
  readonly bytes: Uint8Array;
  readonly play: Play;
  readonly verdict: PlayVerdict;
  /** The verdict in words. */
  readonly message: string;
  /** What its holds lead to; null unless the verdict is `ok`. */
  readonly replayed: Replayed | null;
}

/** A level as it was played. */
export interface PlayedLevel {
  readonly level: Level;
  readonly hash: string;
}

export interface ShelfState {
  /** The opened plays of the level, in the order in which they were opened. */
  readonly plays: readonly OpenedPlay[];
  /** What they teach; null if there are none. */
  readonly statistics: PlayStatistics | null;
  /** Where players die in them; null if none does. */
  readonly deaths: DeathMap | null;
  /** The level when they were verified, and its hash; null if there are none. */
  readonly of: PlayedLevel | null;
  /** Keys of the attempts and plays that are selected. */
  readonly selected: ReadonlySet<string>;
}

/** The opened plays of a level. */
export interface Shelf {
  readonly store: StoreApi<ShelfState>;
  /** The plays that are not there yet, each once. */
  fresh<T extends { readonly bytes: Uint8Array }>(plays: readonly T[]): T[];
  /**
   * Adds verified plays. They replace those of the level before a change: what both teach together would be of no level.
   * @param statistics of all plays, with the index of each in the order of the shelf
   */
  add(plays: readonly Omit<OpenedPlay, 'key'>[], statistics: PlayStatistics, of: PlayedLevel): readonly OpenedPlay[];
  /** Removes all plays. */
  clear(): void;
  select(keys: Iterable<string>): void;
}

const EMPTY = { plays: [], statistics: null, deaths: null, of: null } as const;

export function createShelf(): Shelf {
  const store = createStore<ShelfState>(() => ({ ...EMPTY, selected: new Set() }));
  let count = 0;
  return {
    store,
    fresh(plays) {
      const texts = new Set(store.getState().plays.map(({ bytes }) => playToText(bytes)));
      return plays.filter(({ bytes }) => {
        const before = texts.size;
        return texts.add(playToText(bytes)).size > before;
      });
    },
    add(plays, statistics, of) {
      const added = plays.map((play): OpenedPlay => ({ ...play, key: `play-${++count}` }));
      const { plays: before, of: known } = store.getState();
      const kept = known?.hash === of.hash ? before : [];
      store.setState({ plays: [...kept, ...added], statistics, deaths: deathMapOf(statistics.all), of });
      return added;
    },
    clear: () => store.setState({ ...EMPTY, selected: new Set() }),
    select: (keys) => store.setState({ selected: new Set(keys) }),
  };
}

/** The opened plays of a level; they stay while the page lives, also when another level is opened in the meantime. */
export const shelfOf = ofDocument(createShelf);
