import type { EditEvent, LevelEntry, ListResponse } from '../../schema/index.ts';
import { inOrderOfPlay } from '../io/index.ts';

/**
 * The events between two states of a folder. If a file is gone and a new file has its content, the file was renamed.
 * @param by the client that made the changes; null: another program
 */
export function changesBetween(before: ListResponse, after: ListResponse, by: string | null): EditEvent[] {
  const old = new Map(before.levels.map((entry) => [entry.id, entry]));
  const now = new Map(after.levels.map((entry) => [entry.id, entry]));
  const gone = before.levels.filter(({ id }) => !now.has(id));
  const byContent = new Map<string, LevelEntry[]>();
  // reversed, because `pop` takes the last one: the first must come first
  for (const entry of gone.toReversed()) {
    if (entry.etag === null) continue;
    const same = byContent.get(entry.etag);
    if (same === undefined) byContent.set(entry.etag, [entry]);
    else same.push(entry);
  }
  const events: EditEvent[] = [];
  const isAccountedFor = new Set<LevelEntry>();
  for (const entry of after.levels) {
    if (entry.etag === null || old.has(entry.id)) continue;
    const from = byContent.get(entry.etag)?.pop();
    if (from === undefined) continue;
    isAccountedFor.add(from).add(entry);
    events.push({ type: 'renamed', from: from.id, entry, by });
  }
  for (const entry of gone) if (!isAccountedFor.has(entry)) events.push({ type: 'removed', id: entry.id, by });
  for (const entry of after.levels) {
    const other = old.get(entry.id);
    const isNews = other === undefined ? !isAccountedFor.has(entry) : !isSame(other, entry);
    if (isNews) events.push({ type: 'changed', entry, by });
  }
  if (!isSame([before.folders, before.troubles], [after.folders, after.troubles])) events.push({ type: 'list', list: after });
  return events;
}

/** Compares identity first: an entry that was not read again is the same object. */
const isSame = (a: unknown, b: unknown): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);

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
