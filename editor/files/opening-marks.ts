/**
 * Marks of levels that are being opened, stored outside the page. A mark that is still there when a page starts names the level
 * that made the previous page hang.
 */
export interface OpeningMarks {
  /** Marks a level before it is opened. */
  set(place: string): void;
  /** Removes a mark: the level was opened and drawn, or left before that. */
  clear(place: string): void;
  /** Whether an earlier page began to open the level and did not finish. */
  has(place: string): boolean;
  /** Removes all marks of this page, which is left normally and does not hang. */
  leave(): void;
}

const KEY = 'gravity-quest-editor-opening';
/** keeps the list from growing without limit */
const MOST = 50;

/** @param storage null if the browser stores nothing: then nothing is known about earlier pages */
export function createOpeningMarks(storage: Pick<Storage, 'getItem' | 'setItem'> | null): OpeningMarks {
  const own = new Set<string>();
  const read = (): readonly string[] => {
    try {
      const value: unknown = JSON.parse(storage?.getItem(KEY) ?? '[]');
      return Array.isArray(value) ? value.filter((place) => typeof place === 'string') : [];
    } catch {
      return [];
    }
  };
  const write = (places: readonly string[]) => {
    try {
      storage?.setItem(KEY, JSON.stringify(places.slice(-MOST)));
    } catch {
      // no space, or not allowed: nothing is remembered
    }
  };
  const clear = (place: string) => {
    own.delete(place);
    const places = read();
    if (places.includes(place)) write(places.filter((other) => other !== place));
  };
  return {
    set(place) {
      own.add(place);
      write([...read().filter((other) => other !== place), place]);
    },
    clear,
    has: (place) => !own.has(place) && read().includes(place),
    leave() {
      for (const place of [...own]) clear(place);
    },
  };
}
