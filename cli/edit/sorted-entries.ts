import type { LevelEntry } from '../../schema/index.ts';
import { inOrderOfPlay } from './level-files.ts';

/** Levels of a folder in the order of play. */
export class SortedEntries {
  /** @param entries in that order */
  constructor(private entries: LevelEntry[]) {}

  get all(): readonly LevelEntry[] {
    return this.entries;
  }

  get(id: string): LevelEntry | undefined {
    const entry = this.entries[this.placeOf(id)];
    return entry?.id === id ? entry : undefined;
  }

  /** Puts an entry in its place, instead of the one of its id. */
  put(entry: LevelEntry): void {
    const { entries } = this;
    const last = entries.at(-1);
    // most come in order
    const place = last === undefined || inOrderOfPlay(last.id, entry.id) < 0 ? entries.length : this.placeOf(entry.id);
    entries.splice(place, entries[place]?.id === entry.id ? 1 : 0, entry);
  }

  remove(id: string): void {
    const place = this.placeOf(id);
    if (this.entries[place]?.id === id) this.entries.splice(place, 1);
  }

  /** @param entries in the order of play */
  replace(entries: LevelEntry[]): void {
    this.entries = entries;
  }

  /** Where an id is, or belongs. */
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
