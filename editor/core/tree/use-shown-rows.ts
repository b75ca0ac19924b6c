import { useVirtualizer } from '@tanstack/react-virtual';
import { type RefObject, useEffect, useRef } from 'react';
import { FINGER, useCoarse } from '../ui/index.ts';
import type { TreeRow } from './tree-rows.ts';

/** The rows that are rendered, out of any number. The active one is scrolled into view. */
export function useShownRows<R extends TreeRow>(
  scroller: RefObject<HTMLDivElement | null>,
  rows: readonly R[],
  rowHeight: (row: R) => number,
  activeIndex: number,
) {
  const least = useCoarse() ? FINGER : 0;
  const virtual = useVirtualizer({
    count: rows.length,
    getScrollElement: () => scroller.current,
    estimateSize: (index) => Math.max(least, rowHeight(rows[index])),
    getItemKey: (index) => rows[index].key,
    overscan: 8,
  });

  const measure = useRef(virtual.measure);
  measure.current = virtual.measure;
  // biome-ignore lint/correctness/useExhaustiveDependencies: another pointer or other rows, other heights
  useEffect(() => measure.current(), [least, rowHeight]);

  // Scrolls to the active row, whatever made it active.
  const scrollTo = useRef(virtual.scrollToIndex);
  scrollTo.current = virtual.scrollToIndex;
  useEffect(() => {
    if (activeIndex >= 0) scrollTo.current(activeIndex, { align: 'auto' });
  }, [activeIndex]);

  return virtual;
}
