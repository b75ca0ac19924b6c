import type { Level } from '../../schema/basics/index.ts';

/** A level of a pack. */
export interface PackLevel {
  /** A name that stays while the level is edited or moved within the pack, such as the name of its file. */
  readonly id: string;
  /** The level. */
  readonly level: Level;
}

/** Where progress is kept; `localStorage` is one. */
export interface PackStorage {
  /**
   * Reads a text.
   *
   * @param key - its key
   * @returns the text, or null if there is none
   */
  getItem(key: string): string | null;
  /**
   * Keeps a text.
   *
   * @param key - its key
   * @param value - the text
   */
  setItem(key: string, value: string): void;
}

/** The best play of a level: the one with most minerals, and of these the shortest. */
export interface Best {
  /** The tick in which she reached the black hole. */
  readonly tick: number;
  /** Minerals that she had collected. */
  readonly minerals: number;
  /** The play: the bytes of its `.gqr` file as base64url text; null if it was not recorded. */
  readonly play: string | null;
}

/** Levels in order, and how far the player has come. */
export interface Pack {
  /** The levels, in order. */
  readonly levels: readonly PackLevel[];
  /** Why progress is not kept, for the player, such as a full storage; null while it is. */
  readonly trouble: string | null;
  /**
   * Says how well a level has been played.
   *
   * @param id - the level's id
   * @returns the best play; null if the level has not been completed
   */
  best(id: string): Best | null;
  /**
   * Says whether a level may be played: the first one, one that follows a completed one, or one that has been completed.
   *
   * @param id - the level's id
   * @returns true if it may be played
   */
  isUnlocked(id: string): boolean;
  /**
   * Finds what to play next.
   *
   * @param after - the id of a level; the level behind it is next. Without it, the first unlocked level that is not completed
   * @returns the id of the level; null after the last one, or when all are completed
   */
  next(after?: string): string | null;
  /**
   * Keeps a completed play if it is better than the best one so far, also than one from another tab.
   *
   * @param id - the level's id
   * @param play - the play
   * @returns whether it is the best one now
   * @throws {RangeError} when the level is not in the pack, or the play has no tick or minerals
   */
  record(id: string, play: Best): boolean;
}

class LevelPack implements Pack {
  private readonly places: ReadonlyMap<string, number>;

  constructor(
    readonly levels: readonly PackLevel[],
    private readonly progress: Progress,
  ) {
    const places = new Map<string, number>();
    for (const [i, { id }] of levels.entries()) {
      const other = places.get(id);
      if (other !== undefined) {
        throw new RangeError(
          `createPack: expected a different id for each level, found ${JSON.stringify(id)} for levels ${other + 1} and ${i + 1}. ` +
            'Use the names of their files.',
        );
      }
      places.set(id, i);
    }
    this.places = places;
  }

  get trouble(): string | null {
    return this.progress.trouble;
  }

  private placeOf(id: string): number {
    const place = this.places.get(id);
    if (place === undefined) {
      throw new RangeError(`expected the id of a level in this pack, found ${JSON.stringify(id)}. Its levels list the ids.`);
    }
    return place;
  }

  best(id: string): Best | null {
    this.placeOf(id);
    return this.progress.best(id);
  }

  isUnlocked(id: string): boolean {
    const place = this.placeOf(id);
    return place === 0 || this.best(id) !== null || this.best(this.levels[place - 1].id) !== null;
  }

  next(after?: string): string | null {
    if (after !== undefined) return this.levels[this.placeOf(after) + 1]?.id ?? null;
    return this.levels.find(({ id }) => this.best(id) === null && this.isUnlocked(id))?.id ?? null;
  }

  record(id: string, play: Best): boolean {
    this.placeOf(id);
    if (!isBest(play)) {
      throw new RangeError(
        `record: expected the tick and the minerals as whole numbers from 0, and the play as text or null; found ${JSON.stringify(play)}.`,
      );
    }
    const old = this.best(id);
    if (old !== null && !isBetter(play, old)) return false;
    return this.progress.keep(id, play);
  }
}

/**
 * Puts levels in order and keeps the player's progress. Trouble with the storage never throws: without one that works, progress
 * lasts as long as the page.
 *
 * @param levels - the levels, in order
 * @param storage - where progress is kept, such as `localStorage`; null or nothing: nowhere
 * @param key - under which key
 * @returns the pack
 * @throws {RangeError} when two levels have the same id
 *
 * @example
 * ```ts
 * const pack = createPack(levels, browserStorage());
 * const id = pack.next() ?? pack.levels[0].id;
 * ```
 */
export function createPack(levels: readonly PackLevel[], storage: PackStorage | null = null, key: string = PROGRESS_KEY): Pack {
  return new LevelPack(levels, new Progress(storage, key));
}

/** The key of progress if the game names none. */
const PROGRESS_KEY = 'gravity-quest-progress';

const VERSION = 1;

/** What is kept of a text that is not progress: this many under keys of their own. */
const MOST_KEPT = 20;

const isBetter = (one: Best, other: Best): boolean =>
  one.minerals > other.minerals || (one.minerals === other.minerals && one.tick < other.tick);

const isCount = (value: unknown): value is number => typeof value === 'number' && Number.isSafeInteger(value) && value >= 0;

const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const isBest = (value: unknown): value is Best =>
  isObject(value) && isCount(value.tick) && isCount(value.minerals) && (value.play === null || typeof value.play === 'string');

/** What is read from the storage. `isWhole`: every entry was understood. */
interface Reading {
  readonly bests: Map<string, Best>;
  readonly isWhole: boolean;
}

function read(text: string | null): Reading {
  const bests = new Map<string, Best>();
  if (text === null) return { bests, isWhole: true };
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return { bests, isWhole: false };
  }
  if (!isObject(value) || value.version !== VERSION || !isObject(value.levels)) return { bests, isWhole: false };
  const entries = Object.entries(value.levels);
  for (const [id, entry] of entries)
    if (isBest(entry)) bests.set(id, { tick: entry.tick, minerals: entry.minerals, play: entry.play });
  return { bests, isWhole: bests.size === entries.length };
}

/** The best plays by the id of their level, in a storage that may be missing, full, or written by others. */
class Progress {
  trouble: string | null = null;
  private readonly bests = new Map<string, Best>();

  constructor(
    private readonly storage: PackStorage | null,
    private readonly key: string,
  ) {
    this.merge();
  }

  best(id: string): Best | null {
    return this.bests.get(id) ?? null;
  }

  /** Keeps the best play of a level. @returns false if another tab has kept a better one */
  keep(id: string, { tick, minerals, play }: Best): boolean {
    const mine = { tick, minerals, play };
    const isOverwritable = this.merge();
    const theirs = this.best(id);
    if (theirs !== null && !isBetter(mine, theirs)) return false;
    this.bests.set(id, mine);
    if (isOverwritable) this.write();
    return true;
  }

  /** Takes what is better in the storage. @returns whether the storage may be overwritten without a loss */
  private merge(): boolean {
    const { storage, key } = this;
    if (storage === null) return false;
    let text: string | null;
    try {
      text = storage.getItem(key);
    } catch (error) {
      this.trouble = `Progress can't be read from the browser's storage: ${wordsOf(error)}.`;
      return false;
    }
    const { bests, isWhole } = read(text);
    for (const [id, theirs] of bests) {
      const mine = this.best(id);
      if (mine === null || isBetter(theirs, mine)) this.bests.set(id, theirs);
    }
    return isWhole || text === null || this.putAside(storage, text);
  }

  /** Keeps a text that is not progress, or not all of it, under another key. @returns whether it is kept */
  private putAside(storage: PackStorage, text: string): boolean {
    const { key } = this;
    try {
      for (let i = 1; i <= MOST_KEPT; i++) {
        const there = storage.getItem(`${key}.kept-${i}`);
        if (there === null) storage.setItem(`${key}.kept-${i}`, text);
        if (there === null || there === text) return true;
      }
      this.trouble = `Progress is not kept: ${key} in the browser's storage has been written by something else, time and again.`;
    } catch (error) {
      this.trouble = `Progress is not kept: ${key} in the browser's storage is not progress, and can't be put aside: ${wordsOf(error)}.`;
    }
    return false;
  }

  private write(): void {
    const levels = Object.fromEntries(this.bests);
    try {
      this.storage?.setItem(this.key, JSON.stringify({ version: VERSION, levels }));
      this.trouble = null;
    } catch (error) {
      this.trouble = `Progress lasts until this page is closed: the browser's storage takes nothing more: ${wordsOf(error)}.`;
    }
  }
}

const wordsOf = (error: unknown): string => (error instanceof Error ? error.message.replace(/\.$/, '') : String(error));
