import type { LevelEntry } from '../../schema/index.ts';
import { inOrderOfPlay } from '../io/index.ts';

/** The levels of a folder in order of play. */
export class SortedEntries {
  /** @param entries in order of play */
  constructor(private entries: LevelEntry[]) {}

  get all(): readonly LevelEntry[] {
    return this.entries;
  }

  get(id: string): LevelEntry | undefined {
    const entry = this.entries[this.placeOf(id)];
    return entry?.id === id ? entry : undefined;
  }

  /** Inserts an entry at its place, or replaces the one with the same id. */
  put(entry: LevelEntry): void {
    const { entries } = this;
    const last = entries.at(-1);
    // most entries arrive in order
    const place = last === undefined || inOrderOfPlay(last.id, entry.id) < 0 ? entries.length : this.placeOf(entry.id);
    entries.splice(place, entries[place]?.id === entry.id ? 1 : 0, entry);
  }

  remove(id: string): void {
    const place = this.placeOf(id);
    if (this.entries[place]?.id === id) this.entries.splice(place, 1);
  }

  /** Replaces all entries. @param entries in order of play */
  replace(entries: LevelEntry[]): void {
    this.entries = entries;
  }

  /** The index of an id, or the index at which it would be inserted. */
  private placeOf(id: string): number {
    const { entries } = this;
    let [low, high] = [0, entries.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (inOrderOfPlay(entries[middle].id, id) < 0) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
