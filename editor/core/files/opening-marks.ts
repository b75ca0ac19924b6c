/**
 * Marks of levels that are being opened, stored outside the page. A mark that is still there when a page starts names the level
 * that made the previous page hang.
 */
export interface OpeningMarks {
  /** Marks a level before it is opened. */
  set(place: string): void;
  /** Removes a mark: the level was opened and drawn, or left before that. The mark of a tab that is just opening it stays. */
  clear(place: string): void;
  /** Whether an earlier page of this tab, or a page that hangs in another, began to open the level and did not finish. */
  has(place: string): boolean;
  /** Removes all marks of this page, which is left normally and does not hang. */
  leave(): void;
}

const KEY = 'gravity-quest-editor-opening';
const TAB = 'gravity-quest-editor-tab';
/** keeps the list from growing without limit */
const MOST = 50;
/** ms after which a page that still opens a level hangs; before, another tab may just be opening it */
const PATIENCE = 10_000;

interface Mark {
  readonly place: string;
  /** The tab that opens it. */
  readonly tab: string;
  /** ms */
  readonly at: number;
}

/** A name of this tab that a reload keeps; a new one if the browser stores nothing. */
export function tabName(storage: Pick<Storage, 'getItem' | 'setItem'> | null): string {
  const fresh = crypto.randomUUID();
  try {
    const kept = storage?.getItem(TAB) ?? fresh;
    storage?.setItem(TAB, kept);
    return kept;
  } catch {
    return fresh;
  }
}

/** A stored mark; null if it is none. An earlier version of the editor stored only the place. */
function markOf(value: unknown): Mark | null {
  if (typeof value === 'string') return { place: value, tab: '', at: 0 };
  const { place, tab, at } = (value ?? {}) as Partial<Record<keyof Mark, unknown>>;
  return typeof place === 'string' && typeof tab === 'string' && typeof at === 'number' ? { place, tab, at } : null;
}

/**
 * @param storage null if the browser stores nothing: then nothing is known about earlier pages
 * @param tab the name of this tab: a mark that it made itself is one of an earlier page, which is gone
 */
export function createOpeningMarks(
  storage: Pick<Storage, 'getItem' | 'setItem'> | null,
  tab: string,
  now: () => number = Date.now,
): OpeningMarks {
  const own = new Set<string>();
  const read = (): readonly Mark[] => {
    try {
      const value: unknown = JSON.parse(storage?.getItem(KEY) ?? '[]');
      return Array.isArray(value) ? value.map(markOf).filter((mark) => mark !== null) : [];
    } catch {
      return [];
    }
  };
  const write = (marks: readonly Mark[]) => {
    try {
      storage?.setItem(KEY, JSON.stringify(marks.slice(-MOST)));
    } catch {
      // no space, or not allowed: nothing is remembered
    }
  };
  /** Whether no page is about to remove the mark. */
  const isLeft = (mark: Mark) => mark.tab === tab || Math.abs(now() - mark.at) > PATIENCE;
  const isOther = (place: string) => (mark: Mark) => mark.place !== place || !isLeft(mark);
  const clear = (place: string) => {
    own.delete(place);
    const marks = read();
    const others = marks.filter(isOther(place));
    if (others.length < marks.length) write(others);
  };
  return {
    set(place) {
      own.add(place);
      write([...read().filter(isOther(place)), { place, tab, at: now() }]);
    },
    clear,
    has: (place) => !own.has(place) && !read().every(isOther(place)),
    leave() {
      for (const place of [...own]) clear(place);
    },
  };
}
