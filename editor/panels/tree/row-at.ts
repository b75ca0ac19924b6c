import type { TreeRow } from './tree-rows.ts';

/** The element of a row that an event is about; null where it is about none. */
export const rowElement = (target: EventTarget | null): HTMLElement | null =>
  target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;

/** The row that an event is about; null where it is about none. */
export function rowAt<R extends TreeRow>(rows: readonly R[], target: EventTarget | null): R | null {
  const element = rowElement(target);
  return element === null ? null : (rows[Number(element.dataset.index)] ?? null);
}
