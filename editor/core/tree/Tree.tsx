import { type KeyboardEvent, type MouseEvent, useId, useRef } from 'react';
import { rowAt } from './row-at.ts';
import { showMenu } from './show-menu.ts';
import { TreeMenu } from './TreeMenu.tsx';
import './tree.css';
import { actOnKey } from './tree-keys.ts';
import type { TreeProps } from './tree-props.ts';
import type { TreeRow } from './tree-rows.ts';
import { useRowDrag } from './use-row-drag.ts';
import { useShownRows } from './use-shown-rows.ts';

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
