import { isBest, isBetter, PROGRESS_KEY, Progress } from './progress.ts';
import type { Best, PackLevel, PackStorage } from './types.ts';

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
