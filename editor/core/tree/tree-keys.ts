import type { KeyboardEvent } from 'react';
import { parentOf, stepFrom, type TreeProps, type TreeRow } from './tree-rows.ts';

/** What the keys need to know about the rendered tree. */
interface ShownTree {
  /** The number of rows that a page key moves by. */
  readonly page: number;
  /** Opens the menu of the active row. */
  readonly showMenu: () => void;
}

/**
 * Handles a key in a tree: arrows move and fold, Alt and an arrow reorders, Enter opens the row, the menu key opens its menu.
 * @returns whether it handled the key
 */
export function actOnKey<R extends TreeRow>(event: KeyboardEvent, tree: TreeProps<R>, shown: ShownTree): boolean {
  const row = tree.rows.find(({ key }) => key === tree.active);
  if (event.altKey && row !== undefined && (event.key === 'ArrowUp' || event.key === 'ArrowDown')) {
    moveRow(tree, row, event.key === 'ArrowUp' ? -1 : 1);
    return true;
  }
  if (event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey)) {
    shown.showMenu();
    return true;
  }
  if (row !== undefined && tree.onKey?.(event, row) === true) return true;
  if (event.altKey || event.ctrlKey || event.metaKey) return false;
  return walkByKey(event, tree, shown.page) || actOnRow(event, tree, row);
}

function moveRow<R extends TreeRow>({ onMove }: TreeProps<R>, row: R, by: number): void {
  const place = row.place + by;
  if (row.list !== null && place >= 0 && place < row.siblings) onMove?.(row, place);
}

function walkByKey<R extends TreeRow>(event: KeyboardEvent, tree: TreeProps<R>, page: number): boolean {
  const { rows, active } = tree;
  switch (event.key) {
    case 'ArrowDown':
      walk(event, tree, stepFrom(rows, active, 1));
      return true;
    case 'ArrowUp':
      walk(event, tree, stepFrom(rows, active, -1));
      return true;
    case 'PageDown':
      walk(event, tree, stepFrom(rows, active, page));
      return true;
    case 'PageUp':
      walk(event, tree, stepFrom(rows, active, -page));
      return true;
    case 'Home':
      walk(event, tree, rows[0] ?? null);
      return true;
    case 'End':
      walk(event, tree, rows[rows.length - 1] ?? null);
      return true;
    default:
      return false;
  }
}

function actOnRow<R extends TreeRow>(event: KeyboardEvent, tree: TreeProps<R>, row: R | undefined): boolean {
  const { rows, active, onToggle, onPick, onOpen } = tree;
  switch (event.key) {
    case 'ArrowRight':
      if (row?.expanded === false) onToggle?.(row);
      else if (row?.expanded === true) walk(event, tree, stepFrom(rows, active, 1));
      return true;
    case 'ArrowLeft':
      if (row?.expanded === true) onToggle?.(row);
      else if (row !== undefined) walk(event, tree, parentOf(rows, row.key));
      return true;
    case 'Enter':
      if (row?.expanded != null) onToggle?.(row);
      else if (row !== undefined) (onOpen ?? ((opened: R) => onPick(opened, { shift: false, mod: false })))(row);
      return true;
    default:
      return false;
  }
}

function walk<R extends TreeRow>(
  event: KeyboardEvent,
  { rows, onActive, follows, onPick }: TreeProps<R>,
  to: TreeRow | null,
): void {
  const row = rows.find(({ key }) => key === to?.key);
  if (row === undefined) return;
  onActive(row.key);
  if (follows) onPick(row, { shift: event.shiftKey, mod: false });
}
