import type { KeyboardEvent, ReactNode } from 'react';

/** A row of a tree; rows are given in display order. */
export interface TreeRow {
  readonly key: string;
  /** from 1 */
  readonly depth: number;
  /** The text of the row when it is dragged out of the tree. */
  readonly label: string;
  /** null for a leaf */
  readonly expanded: boolean | null;
  /** Rows of the same list can be reordered; null: the row is fixed. */
  readonly list: string | null;
  /** Its index among its siblings, from 0, and their number. */
  readonly place: number;
  readonly siblings: number;
}

/** An entry of a row's context menu; null is a separator. */
export type MenuEntry = {
  readonly title: string;
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly run: () => void;
} | null;

/** The row `by` steps away among the shown rows, limited to the first and last. */
export function stepFrom(rows: readonly TreeRow[], key: string | null, by: number): TreeRow | null {
  if (rows.length === 0) return null;
  const index = rows.findIndex((row) => row.key === key);
  if (index < 0) return by < 0 ? rows[rows.length - 1] : rows[0];
  return rows[Math.min(rows.length - 1, Math.max(0, index + by))];
}

/** The parent of a row; null on the top level. */
export function parentOf(rows: readonly TreeRow[], key: string): TreeRow | null {
  const index = rows.findIndex((row) => row.key === key);
  for (let i = index - 1; i >= 0; i--) if (rows[i].depth < rows[index].depth) return rows[i];
  return null;
}

/** The keys of the leaves from one row to another, inclusive, in display order. */
export function leavesBetween(rows: readonly TreeRow[], from: string, to: string): string[] {
  const [a, b] = [rows.findIndex(({ key }) => key === from), rows.findIndex(({ key }) => key === to)];
  if (a < 0 || b < 0) return [to];
  return rows
    .slice(Math.min(a, b), Math.max(a, b) + 1)
    .filter(({ expanded }) => expanded === null)
    .map(({ key }) => key);
}

/**
 * The new place of a row that is dropped on another row of its list.
 * @param below whether the pointer is over the lower half of that row
 * @returns the new place, or null if nothing would change
 */
export function dropPlace(dragged: TreeRow, over: TreeRow, below: boolean): number | null {
  if (dragged.list === null || dragged.list !== over.list) return null;
  const gap = over.place + (below ? 1 : 0);
  const place = gap > dragged.place ? gap - 1 : gap;
  return place === dragged.place ? null : place;
}

/** Modifier keys that are held. */
export interface Modifiers {
  readonly shift: boolean;
  readonly mod: boolean;
}

export interface TreeProps<R extends TreeRow> {
  readonly label: string;
  readonly rows: readonly R[];
  /** px */
  readonly rowHeight: (row: R) => number;
  readonly selected: ReadonlySet<string>;
  /** The row whose object is hovered elsewhere. */
  readonly hovered?: string | null;
  readonly multiple?: boolean;
  /** The row that keys act on. */
  readonly active: string | null;
  readonly onActive: (key: string) => void;
  readonly render: (row: R) => ReactNode;
  /** A click, or arrow keys if `follows` is set. */
  readonly onPick: (row: R, how: Modifiers) => void;
  /** Whether moving with the arrow keys also picks. */
  readonly follows?: boolean;
  /** A double-click or Enter. */
  readonly onOpen?: (row: R) => void;
  readonly onToggle?: (row: R) => void;
  /** Called when a row is moved to another place in its list, by dragging or by Alt and an arrow key. */
  readonly onMove?: (row: R, place: number) => void;
  /** Handles other keys. @returns whether it handled the key */
  readonly onKey?: (event: KeyboardEvent, row: R) => boolean;
  readonly onHover?: (row: R | null) => void;
  readonly menu?: (row: R) => readonly MenuEntry[];
}

/** A set with a value that was not in it, or without one that was. */
export function toggledIn<T>(values: ReadonlySet<T>, value: T): ReadonlySet<T> {
  const toggled = new Set(values);
  if (!toggled.delete(value)) toggled.add(value);
  return toggled;
}
