import { useVirtualizer } from '@tanstack/react-virtual';
import { ContextMenu } from 'radix-ui';
import {
  type DragEvent,
  Fragment,
  type KeyboardEvent,
  type MouseEvent,
  type ReactNode,
  useEffect,
  useId,
  useRef,
  useState,
} from 'react';
import { FINGER, useCoarse } from '../../ui/index.ts';
import { showMenu } from './show-menu.ts';
import './tree.css';
import { dropPlace, type MenuEntry, parentOf, stepFrom, type TreeRow } from './tree-rows.ts';

/** What the person holds down. */
export interface Modifiers {
  readonly shift: boolean;
  readonly mod: boolean;
}

interface TreeProps<R extends TreeRow> {
  readonly label: string;
  readonly rows: readonly R[];
  /** px */
  readonly rowHeight: (row: R) => number;
  readonly selected: ReadonlySet<string>;
  /** The row that is pointed at elsewhere. */
  readonly hovered?: string | null;
  readonly multiple?: boolean;
  /** The row that the keys act on. */
  readonly active: string | null;
  readonly onActive: (key: string) => void;
  readonly render: (row: R) => ReactNode;
  /** A click, or arrow keys where `follows` is set. */
  readonly onPick: (row: R, how: Modifiers) => void;
  /** Whether walking with the arrow keys picks, too. */
  readonly follows?: boolean;
  /** A double click, Enter. */
  readonly onOpen?: (row: R) => void;
  readonly onToggle?: (row: R) => void;
  /** Dragged, or moved by Alt and an arrow key, to another place in its list. */
  readonly onMove?: (row: R, place: number) => void;
  /** Other keys. @returns whether it knew the key */
  readonly onKey?: (event: KeyboardEvent, row: R) => boolean;
  readonly onHover?: (row: R | null) => void;
  readonly menu?: (row: R) => readonly MenuEntry[];
}

/** A list or tree of any length, for the pointer and for keys: arrows walk, Enter opens, Alt + arrows move, the menu key shows what can be done. */
export function Tree<R extends TreeRow>(props: TreeProps<R>) {
  const {
    label,
    rows,
    rowHeight,
    selected,
    hovered = null,
    multiple = false,
    active,
    onActive,
    render,
    onPick,
    follows = false,
  } = props;
  const { onOpen, onToggle, onMove, onKey, onHover, menu } = props;
  const id = useId();
  const least = useCoarse() ? FINGER : 0;
  const scroller = useRef<HTMLDivElement>(null);
  const [dragged, setDragged] = useState<R | null>(null);
  const [drop, setDrop] = useState<{ readonly index: number; readonly below: boolean; readonly place: number } | null>(null);
  const virtual = useVirtualizer({
    count: rows.length,
    getScrollElement: () => scroller.current,
    estimateSize: (index) => Math.max(least, rowHeight(rows[index])),
    getItemKey: (index) => rows[index].key,
    overscan: 8,
  });
  const activeIndex = rows.findIndex(({ key }) => key === active);

  const measure = useRef(virtual.measure);
  measure.current = virtual.measure;
  // biome-ignore lint/correctness/useExhaustiveDependencies: another pointer, other heights
  useEffect(() => measure.current(), [least]);

  // whoever made it active, it is to be seen
  const scrollTo = useRef(virtual.scrollToIndex);
  scrollTo.current = virtual.scrollToIndex;
  useEffect(() => {
    if (activeIndex >= 0) scrollTo.current(activeIndex, { align: 'auto' });
  }, [activeIndex]);

  const rowAt = (target: EventTarget | null): R | null => {
    const element = target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;
    return element === null ? null : (rows[Number(element.dataset.index)] ?? null);
  };
  const walk = (to: TreeRow | null, event: KeyboardEvent) => {
    const row = rows.find(({ key }) => key === to?.key);
    if (row === undefined) return;
    onActive(row.key);
    if (follows) onPick(row, { shift: event.shiftKey, mod: false });
  };
  const move = (row: R, by: number) => {
    const place = row.place + by;
    if (row.list !== null && place >= 0 && place < row.siblings) onMove?.(row, place);
  };

  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    const row = rows[activeIndex];
    const page = Math.max(1, (virtual.range?.endIndex ?? 0) - (virtual.range?.startIndex ?? 0) - 1);
    const known = (): boolean => {
      if (event.altKey && row !== undefined && (event.key === 'ArrowUp' || event.key === 'ArrowDown')) {
        move(row, event.key === 'ArrowUp' ? -1 : 1);
        return true;
      }
      if (event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey)) {
        const element = scroller.current?.querySelector(`[data-index="${activeIndex}"]`);
        if (element != null) showMenu(element);
        return true;
      }
      if (row !== undefined && onKey?.(event, row) === true) return true;
      if (event.altKey || event.ctrlKey || event.metaKey) return false;
      switch (event.key) {
        case 'ArrowDown':
          walk(stepFrom(rows, active, 1), event);
          return true;
        case 'ArrowUp':
          walk(stepFrom(rows, active, -1), event);
          return true;
        case 'PageDown':
          walk(stepFrom(rows, active, page), event);
          return true;
        case 'PageUp':
          walk(stepFrom(rows, active, -page), event);
          return true;
        case 'Home':
          walk(rows[0] ?? null, event);
          return true;
        case 'End':
          walk(rows[rows.length - 1] ?? null, event);
          return true;
        case 'ArrowRight':
          if (row?.expanded === false) onToggle?.(row);
          else if (row?.expanded === true) walk(stepFrom(rows, active, 1), event);
          return true;
        case 'ArrowLeft':
          if (row?.expanded === true) onToggle?.(row);
          else if (row !== undefined) walk(parentOf(rows, row.key), event);
          return true;
        case 'Enter':
          if (row?.expanded != null) onToggle?.(row);
          else if (row !== undefined) (onOpen ?? ((opened: R) => onPick(opened, { shift: false, mod: false })))(row);
          return true;
        default:
          return false;
      }
    };
    if (known()) event.preventDefault();
  };

  const onClick = (event: MouseEvent<HTMLDivElement>) => {
    const row = rowAt(event.target);
    if (row === null) return;
    onActive(row.key);
    if (row.expanded !== null) onToggle?.(row);
    else onPick(row, { shift: event.shiftKey, mod: event.ctrlKey || event.metaKey });
  };
  const dropAt = (event: DragEvent<HTMLDivElement>) => {
    if (dragged === null) return null;
    const row = rowAt(event.target);
    // the room below all rows is that below the last one
    const over = row ?? rows.findLast(({ list }) => list === dragged.list) ?? null;
    if (over === null) return null;
    const box = (event.target as Element).closest('[data-index]')?.getBoundingClientRect();
    const below = box === undefined || event.clientY > box.top + box.height / 2;
    const place = dropPlace(dragged, over, below);
    return place === null ? null : { index: rows.indexOf(over), below, place };
  };
  const endDrag = () => {
    setDragged(null);
    setDrop(null);
  };
  const line = virtual.getVirtualItems().find(({ index }) => index === drop?.index);
  const entries = menu === undefined || activeIndex < 0 ? [] : menu(rows[activeIndex]);

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
        const row = rowAt(event.target);
        if (row !== null && row.expanded === null) onOpen?.(row);
      }}
      onContextMenu={(event) => {
        const row = rowAt(event.target);
        if (row !== null) onActive(row.key);
      }}
      onMouseOver={(event) => onHover?.(rowAt(event.target))}
      onMouseLeave={() => onHover?.(null)}
      onDragStart={(event) => {
        const row = rowAt(event.target);
        if (row === null) return;
        event.dataTransfer.effectAllowed = 'move';
        event.dataTransfer.setData('text/plain', row.label);
        setDragged(row);
      }}
      onDragOver={(event) => {
        const at = dropAt(event);
        if (at !== null) event.preventDefault();
        setDrop((now) => (now?.index === at?.index && now?.below === at?.below ? now : at));
      }}
      onDragLeave={(event) => {
        const to = event.relatedTarget;
        if (!(to instanceof Node && event.currentTarget.contains(to))) setDrop(null);
      }}
      onDrop={(event) => {
        const at = dropAt(event);
        if (at !== null && dragged !== null) {
          event.preventDefault();
          onMove?.(dragged, at.place);
        }
        endDrag();
      }}
      onDragEnd={endDrag}
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
  return (
    <ContextMenu.Root>
      <ContextMenu.Trigger asChild>{tree}</ContextMenu.Trigger>
      <ContextMenu.Portal>
        <ContextMenu.Content className="menu" collisionPadding={8}>
          {entries.map((entry, index) =>
            entry === null ? (
              // biome-ignore lint/suspicious/noArrayIndexKey: lines have no name, and the menu is made anew each time
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
