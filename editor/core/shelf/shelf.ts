import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Attempt, FailureCause, PlayStatistics, Attempt as Replayed } from '../../../check/plays/index.ts';
import { levelHash, type Play, type PlayVerdict, playToText } from '../../../game/index.ts';
import type { Level } from '../../../schema/index.ts';
import { causeInWords } from '../attempts/index.ts';
import type { OpenLevel } from '../context/index.ts';
import { keptWith, ofDocument } from '../kept/index.ts';

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
interface PlayedLevel {
  readonly level: Level;
  readonly hash: string;
}

interface ShelfState {
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

/** Side of a square of the map, px: about the width of the astronaut. */
const SIDE = 24;

/** Where players die: squares with the number of deaths in each. */
export interface DeathMap {
  /** Side of a square, px. */
  readonly cellSize: number;
  /** The middle of each square, px, and the deaths in it. */
  readonly cells: readonly { readonly x: number; readonly y: number; readonly visits: number }[];
  /** The number of all deaths. */
  readonly deaths: number;
  /** Who died in each square, by its place in the grid. */
  readonly squares: ReadonlyMap<string, readonly Death[]>;
}

interface Death {
  readonly x: number;
  readonly y: number;
  readonly cause: FailureCause;
}

const DEADLY: ReadonlySet<FailureCause['kind']> = new Set(['nova', 'asteroid', 'alien', 'lost']);

const indexOf = (place: number): number => Math.floor(place / SIDE);
const keyOf = (column: number, row: number): string => `${column},${row}`;

/** The map of the attempts in which she dies; null if there is none. Time-outs and attempts that were left are no deaths. */
export function deathMapOf(attempts: readonly Pick<Attempt, 'x' | 'y' | 'cause'>[]): DeathMap | null {
  const squares = new Map<string, Death[]>();
  let deaths = 0;
  for (const { x, y, cause } of attempts) {
    if (cause === null || !DEADLY.has(cause.kind)) continue;
    deaths++;
    const key = keyOf(indexOf(x), indexOf(y));
    const square = squares.get(key);
    if (square === undefined) squares.set(key, [{ x, y, cause }]);
    else square.push({ x, y, cause });
  }
  if (deaths === 0) return null;
  const cells = [...squares].map(([key, { length: visits }]) => {
    const [column, row] = key.split(',').map(Number);
    return { x: (column + 0.5) * SIDE, y: (row + 0.5) * SIDE, visits };
  });
  return { cellSize: SIDE, cells, squares, deaths };
}

/** The deaths near a place, by cause, the most frequent first. @param reach px */
export function deathsNear({ squares }: DeathMap, x: number, y: number, reach: number): { cause: string; count: number }[] {
  const counts = new Map<string, number>();
  for (let column = indexOf(x - reach); column <= indexOf(x + reach); column++) {
    for (let row = indexOf(y - reach); row <= indexOf(y + reach); row++) {
      for (const death of squares.get(keyOf(column, row)) ?? []) {
        if ((death.x - x) ** 2 + (death.y - y) ** 2 > reach ** 2) continue;
        const cause = causeInWords(death.cause);
        counts.set(cause, (counts.get(cause) ?? 0) + 1);
      }
    }
  }
  return [...counts].map(([cause, count]) => ({ cause, count })).sort((a, b) => b.count - a.count);
}

const hashOf = keptWith(levelHash);

/** The hash of the open level as it is now. */
export const hashNow = ({ proof }: Pick<OpenLevel, 'proof'>): string => hashOf(proof.proof().level);
