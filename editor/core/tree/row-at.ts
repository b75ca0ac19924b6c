import type { TreeRow } from './tree-rows.ts';

/** The row element of an event's target; null if there is none. */
export const rowElement = (target: EventTarget | null): HTMLElement | null =>
  target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;

/** The row of an event's target; null if there is none. */
export function rowAt<R extends TreeRow>(rows: readonly R[], target: EventTarget | null): R | null {
  const element = rowElement(target);
  return element === null ? null : (rows[Number(element.dataset.index)] ?? null);
}
