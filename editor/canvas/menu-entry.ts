/** An action in the menu of a place. */
export interface MenuAction {
  readonly title: string;
  /** The key, as it is displayed. */
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly run: () => void;
}

/** A menu within the menu. */
export interface SubMenu {
  readonly title: string;
  readonly entries: readonly MenuAction[];
}

/** null is a line */
export type MenuPart = MenuAction | SubMenu | null;
