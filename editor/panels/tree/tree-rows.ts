/** A row of a tree, in the order in which the rows are shown. */
export interface TreeRow {
  readonly key: string;
  /** from 1 */
  readonly depth: number;
  /** What it is called wherever it is dragged to; in the tree it is called by what it shows. */
  readonly label: string;
  /** null: there is nothing below it */
  readonly expanded: boolean | null;
  /** Rows of the same list can change places with each other; null: it stays where it is. */
  readonly list: string | null;
  /** Within its siblings, from 0, and how many there are. */
  readonly place: number;
  readonly siblings: number;
}

/** An entry of a row's menu; null is a line between entries. */
export type MenuEntry = {
  readonly title: string;
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly run: () => void;
} | null;

/** The row that is a step away, among the rows that are shown; the same one at either end. */
export function stepFrom(rows: readonly TreeRow[], key: string | null, by: number): TreeRow | null {
  if (rows.length === 0) return null;
  const index = rows.findIndex((row) => row.key === key);
  if (index < 0) return by < 0 ? rows[rows.length - 1] : rows[0];
  return rows[Math.min(rows.length - 1, Math.max(0, index + by))];
}

/** The row that this one hangs below; null for one of the first level. */
export function parentOf(rows: readonly TreeRow[], key: string): TreeRow | null {
  const index = rows.findIndex((row) => row.key === key);
  for (let i = index - 1; i >= 0; i--) if (rows[i].depth < rows[index].depth) return rows[i];
  return null;
}

/** Keys of the leaves from one row to another, both included, as they are shown. */
export function leavesBetween(rows: readonly TreeRow[], from: string, to: string): string[] {
  const [a, b] = [rows.findIndex(({ key }) => key === from), rows.findIndex(({ key }) => key === to)];
  if (a < 0 || b < 0) return [to];
  return rows
    .slice(Math.min(a, b), Math.max(a, b) + 1)
    .filter(({ expanded }) => expanded === null)
    .map(({ key }) => key);
}

/**
 * Where a dragged row goes when it is let go over another one of its list.
 * @param below whether the pointer is over the lower half of that row
 * @returns its place afterwards, or null where nothing would change
 */
export function dropPlace(dragged: TreeRow, over: TreeRow, below: boolean): number | null {
  if (dragged.list === null || dragged.list !== over.list) return null;
  const gap = over.place + (below ? 1 : 0);
  const place = gap > dragged.place ? gap - 1 : gap;
  return place === dragged.place ? null : place;
}
