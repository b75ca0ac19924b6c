import { type DragEvent, useState } from 'react';
import { dropPlace, type TreeRow } from './tree-rows.ts';

/** Where a dragged row would be dropped. */
interface Drop {
  /** index of the row at whose edge it would be dropped */
  readonly index: number;
  readonly below: boolean;
  /** its new place in its list */
  readonly place: number;
}

/**
 * Lets rows be dragged to another place in their list.
 * @returns the dragged row, where it would be dropped, and the listeners of the tree's element
 */
export function useRowDrag<R extends TreeRow>(rows: readonly R[], onMove: ((row: R, place: number) => void) | undefined) {
  const [dragged, setDragged] = useState<R | null>(null);
  const [drop, setDrop] = useState<Drop | null>(null);

  const dropAt = (event: DragEvent<HTMLDivElement>): Drop | null => {
    if (dragged === null) return null;
    // The space below all rows counts as that below the last one.
    const over = rowAt(rows, event.target) ?? rows.findLast(({ list }) => list === dragged.list) ?? null;
    if (over === null) return null;
    const box = rowElement(event.target)?.getBoundingClientRect();
    const below = box === undefined || event.clientY > box.top + box.height / 2;
    const place = dropPlace(dragged, over, below);
    return place === null ? null : { index: rows.indexOf(over), below, place };
  };
  const end = () => {
    setDragged(null);
    setDrop(null);
  };

  const listeners = {
    onDragStart(event: DragEvent<HTMLDivElement>) {
      const row = rowAt(rows, event.target);
      if (row === null) return;
      event.dataTransfer.effectAllowed = 'move';
      event.dataTransfer.setData('text/plain', row.label);
      setDragged(row);
    },
    onDragOver(event: DragEvent<HTMLDivElement>) {
      const at = dropAt(event);
      if (at !== null) event.preventDefault();
      setDrop((now) => (now?.index === at?.index && now?.below === at?.below ? now : at));
    },
    onDragLeave(event: DragEvent<HTMLDivElement>) {
      const to = event.relatedTarget;
      if (!(to instanceof Node && event.currentTarget.contains(to))) setDrop(null);
    },
    onDrop(event: DragEvent<HTMLDivElement>) {
      const at = dropAt(event);
      if (at !== null && dragged !== null) {
        event.preventDefault();
        onMove?.(dragged, at.place);
      }
      end();
    },
    onDragEnd: end,
  };
  return { dragged, drop, listeners };
}

/** The row element of an event's target; null if there is none. */
const rowElement = (target: EventTarget | null): HTMLElement | null =>
  target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;

/** The row of an event's target; null if there is none. */
export function rowAt<R extends TreeRow>(rows: readonly R[], target: EventTarget | null): R | null {
  const element = rowElement(target);
  return element === null ? null : (rows[Number(element.dataset.index)] ?? null);
}
