import { useVirtualizer } from '@tanstack/react-virtual';
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
  useRef,
} from 'react';
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
  const virtual = useShownRows(scroller, rows, rowHeight, activeIndex);
  const { dragged, drop, listeners } = useRowDrag(rows, onMove);

  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    const page = Math.max(1, (virtual.range?.endIndex ?? 0) - (virtual.range?.startIndex ?? 0) - 1);
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
  const line = virtual.getVirtualItems().find(({ index }) => index === drop?.index);

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
      <div className="tree__space" role="presentation" style={{ height: virtual.getTotalSize() }}>
        {virtual.getVirtualItems().map(({ index, start, size }) => {
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
              style={{ height: size, transform: `translateY(${start}px)`, paddingLeft: 8 + (row.depth - 1) * 14 }}
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

/** The rows that are rendered, out of any number. The active one is scrolled into view. */
function useShownRows<R extends TreeRow>(
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
