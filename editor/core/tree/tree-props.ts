import type { KeyboardEvent, ReactNode } from 'react';
import type { MenuEntry, TreeRow } from './tree-rows.ts';

/** Modifier keys that are held. */
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
  /** The row whose object is hovered elsewhere. */
  readonly hovered?: string | null;
  readonly multiple?: boolean;
  /** The row that keys act on. */
  readonly active: string | null;
  readonly onActive: (key: string) => void;
  readonly render: (row: R) => ReactNode;
  /** A click, or arrow keys if `follows` is set. */
  readonly onPick: (row: R, how: Modifiers) => void;
  /** Whether moving with the arrow keys also picks. */
  readonly follows?: boolean;
  /** A double-click or Enter. */
  readonly onOpen?: (row: R) => void;
  readonly onToggle?: (row: R) => void;
  /** Called when a row is moved to another place in its list, by dragging or by Alt and an arrow key. */
  readonly onMove?: (row: R, place: number) => void;
  /** Handles other keys. @returns whether it handled the key */
  readonly onKey?: (event: KeyboardEvent, row: R) => boolean;
  readonly onHover?: (row: R | null) => void;
  readonly menu?: (row: R) => readonly MenuEntry[];
}
