/** Which levels are just being opened, in a place that outlives a page that hangs: what is still marked when a page begins is what made the last one hang. */
export interface OpeningMarks {
  /** Marks a level before anything is made of it. */
  set(place: string): void;
  /** It was opened and drawn, or the page was left before that. */
  clear(place: string): void;
  /** Whether a page was opening it, and never came to an end. */
  has(place: string): boolean;
  /** Takes back what this page has marked: it is left as pages are, and does not hang. */
  leave(): void;
}

const KEY = 'gravity-quest-editor-opening';
/** The list can't grow without end. */
const MOST = 50;

/** @param storage null where the browser keeps nothing: then nothing is known of the page before */
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
      // no room, or not allowed: nothing is known then
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
