import { EllipsisVertical } from 'lucide-react';
import { ContextMenu } from 'radix-ui';
import {
  Fragment,
  type KeyboardEvent,
  type MouseEvent,
  memo,
  type ReactElement,
  type RefObject,
  useEffect,
  useId,
  useLayoutEffect,
  useMemo,
  useRef,
  useState,
} from 'react';
import { flushSync } from 'react-dom';
import { FINGER, useCoarse } from '../context/index.ts';
import { actOnKey } from './tree-keys.ts';
import type { MenuEntry, TreeProps, TreeRow } from './tree-rows.ts';
import { rowAt, useRowDrag } from './use-row-drag.ts';
import './tree.css';

/**
 * A virtual list or tree for pointer and keyboard: arrows move, Enter opens, Alt + arrows reorder, the menu key opens the
 * context menu.
 */
export function Tree<R extends TreeRow>(props: TreeProps<R>) {
  const { label, rows, rowHeight, selected, hovered = null, multiple = false, active, render } = props;
  const { onActive, onPick, onOpen, onToggle, onMove, onHover, menu } = props;
  const id = useId();
  const scroller = useRef<HTMLDivElement>(null);
  const activeIndex = rows.findIndex(({ key }) => key === active);
  const shown = useShownRows(scroller, rows, rowHeight, activeIndex);
  const { dragged, drop, listeners } = useRowDrag(rows, onMove);

  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    const page = Math.max(1, shown.visible - 2);
    const showActiveMenu = () => {
      const element = scroller.current?.querySelector(`[data-index="${activeIndex}"]`);
      if (element != null) showMenu(element);
    };
    if (actOnKey(event, props, { page, showMenu: showActiveMenu })) event.preventDefault();
  };
  const onClick = (event: MouseEvent<HTMLDivElement>) => {
    const row = rowAt(rows, event.target);
    if (row === null) return;
    onActive(row.key);
    if (row.expanded !== null) onToggle?.(row);
    else onPick(row, { shift: event.shiftKey, mod: event.ctrlKey || event.metaKey });
  };
  const line = shown.places.find(({ index }) => index === drop?.index);

  const tree = (
    <div
      ref={scroller}
      className="tree"
      role="tree"
      aria-label={label}
      aria-multiselectable={multiple || undefined}
      aria-activedescendant={activeIndex < 0 ? undefined : `${id}-${activeIndex}`}
      tabIndex={0}
      onKeyDown={onKeyDown}
      onFocus={() =>
        activeIndex < 0 && rows.length > 0 && onActive(rows.find(({ key }) => selected.has(key))?.key ?? rows[0].key)
      }
      onClick={onClick}
      onDoubleClick={(event) => {
        const row = rowAt(rows, event.target);
        if (row !== null && row.expanded === null) onOpen?.(row);
      }}
      onContextMenu={(event) => {
        const row = rowAt(rows, event.target);
        if (row !== null) onActive(row.key);
      }}
      onMouseOver={(event) => onHover?.(rowAt(rows, event.target))}
      onMouseLeave={() => onHover?.(null)}
      {...listeners}
    >
      <div className="tree__space" role="presentation" style={{ height: shown.height }}>
        {shown.places.map(({ index, start, end }) => {
          const row = rows[index];
          const lit = row.key === hovered ? ' tree__row--hovered' : '';
          const held = row.key === dragged?.key ? ' tree__row--dragged' : '';
          return (
            // biome-ignore lint/a11y/useFocusableInteractive: the tree has the focus, and says which row is active
            <div
              key={row.key}
              id={`${id}-${index}`}
              data-index={index}
              className={`tree__row${index === activeIndex ? ' tree__row--active' : ''}${lit}${held}`}
              role="treeitem"
              aria-level={row.depth}
              aria-expanded={row.expanded ?? undefined}
              aria-selected={row.expanded === null ? selected.has(row.key) : undefined}
              aria-posinset={row.place + 1}
              aria-setsize={row.siblings}
              draggable={onMove !== undefined && row.list !== null}
              style={{ height: end - start, transform: `translateY(${start}px)`, paddingLeft: 8 + (row.depth - 1) * 14 }}
            >
              {render(row)}
            </div>
          );
        })}
        {line !== undefined && drop !== null && (
          <div className="tree__drop" aria-hidden style={{ top: Math.max(2, drop.below ? line.end : line.start) }} />
        )}
      </div>
    </div>
  );
  if (menu === undefined) return tree;
  return <TreeMenu entries={activeIndex < 0 ? [] : menu(rows[activeIndex])}>{tree}</TreeMenu>;
}

/** The context menu of the active row, opened anywhere in the tree. */
function TreeMenu({ entries, children }: { readonly entries: readonly MenuEntry[]; readonly children: ReactElement }) {
  return (
    <ContextMenu.Root>
      <ContextMenu.Trigger asChild>{children}</ContextMenu.Trigger>
      <ContextMenu.Portal>
        <ContextMenu.Content className="menu" collisionPadding={8}>
          {entries.map((entry, index) =>
            entry === null ? (
              // biome-ignore lint/suspicious/noArrayIndexKey: lines have no name, and the menu is rebuilt each time
              <ContextMenu.Separator key={index} className="menu__line" />
            ) : (
              <Fragment key={entry.title}>
                <ContextMenu.Item className="menu__item" disabled={entry.disabled} onSelect={entry.run}>
                  {entry.title}
                  {entry.keys !== undefined && <kbd>{entry.keys}</kbd>}
                </ContextMenu.Item>
              </Fragment>
            ),
          )}
        </ContextMenu.Content>
      </ContextMenu.Portal>
    </ContextMenu.Root>
  );
}

/** Rows that are rendered beyond the visible ones, at both ends. */
const BEYOND = 8;

/** Where a row stands, px from the upper end of the first one. */
interface RowPlace {
  readonly index: number;
  readonly start: number;
  readonly end: number;
}

/** Which rows are rendered, out of any number. */
interface ShownRows {
  readonly places: readonly RowPlace[];
  /** The height of all rows, px. */
  readonly height: number;
  /** The number of rows that are visible. */
  readonly visible: number;
}

/** The index of the row at a height, px. @param ends the lower ends of all rows, px */
function rowAtHeight(ends: readonly number[], height: number): number {
  let [low, high] = [0, ends.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ends[middle] > height) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** The rows to render in an element that scrolls. The active one is scrolled into view, whatever made it active. */
function useShownRows<R extends TreeRow>(
  scroller: RefObject<HTMLDivElement | null>,
  rows: readonly R[],
  rowHeight: (row: R) => number,
  activeIndex: number,
): ShownRows {
  const least = useCoarse() ? FINGER : 0;
  const ends = useMemo(() => {
    let end = 0;
    return rows.map((row) => {
      end += Math.max(least, rowHeight(row));
      return end;
    });
  }, [rows, rowHeight, least]);
  const [{ top, height }, setWindow] = useState({ top: 0, height: 0 });

  const asked = useRef(ends);
  asked.current = ends;
  useLayoutEffect(() => {
    const element = scroller.current;
    if (element === null) return;
    let shown = '';
    const look = () => {
      const { scrollTop, clientHeight } = element;
      const seen = [scrollTop, scrollTop + clientHeight - 1].map((edge) => rowAtHeight(asked.current, edge)).join();
      if (seen !== shown) setWindow({ top: scrollTop, height: clientHeight });
      shown = seen;
    };
    look();
    // before the frame that shows the new place: else it would be empty there
    const onScroll = () => flushSync(look);
    element.addEventListener('scroll', onScroll, { passive: true });
    const resized = new ResizeObserver(look);
    resized.observe(element);
    return () => {
      element.removeEventListener('scroll', onScroll);
      resized.disconnect();
    };
  }, [scroller]);

  useEffect(() => {
    const element = scroller.current;
    if (element === null || activeIndex < 0) return;
    const [start, end] = [asked.current[activeIndex - 1] ?? 0, asked.current[activeIndex]];
    if (end > element.scrollTop + element.clientHeight) element.scrollTop = end - element.clientHeight;
    else if (start < element.scrollTop) element.scrollTop = start;
  }, [scroller, activeIndex]);

  const [first, last] = height === 0 ? [0, -1] : [rowAtHeight(ends, top), rowAtHeight(ends, top + height - 1)];
  const from = Math.max(0, first - BEYOND);
  const places = ends
    .slice(from, last < 0 ? 0 : last + 1 + BEYOND)
    .map((end, i) => ({ index: from + i, start: ends[from + i - 1] ?? 0, end }));
  return { places, height: ends[ends.length - 1] ?? 0, visible: last - first + 1 };
}

/** Opens the context menu of its row. It is not focusable, as the keyboard has the menu key. */
export const MoreButton = memo(function MoreButton() {
  return (
    <button
      type="button"
      className="tree__more"
      tabIndex={-1}
      aria-hidden
      // the focus stays in the tree, which handles the keys
      onMouseDown={(event) => event.preventDefault()}
      onDoubleClick={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        showMenu(event.currentTarget);
      }}
    >
      <EllipsisVertical size={14} />
    </button>
  );
});

/** Opens the context menu of an element below it, as a right-click would. */
function showMenu(element: Element): void {
  const { left, bottom } = element.getBoundingClientRect();
  element.dispatchEvent(new MouseEvent('contextmenu', { bubbles: true, cancelable: true, clientX: left, clientY: bottom }));
}
