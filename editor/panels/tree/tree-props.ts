import type { KeyboardEvent, ReactNode } from 'react';
import type { MenuEntry, TreeRow } from './tree-rows.ts';

/** What the person holds down. */
export interface Modifiers {
  readonly shift: boolean;
  readonly mod: boolean;
}

export interface TreeProps<R extends TreeRow> {
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
