import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Box, Point, View } from './view.ts';

/** What the canvas shows besides the level: the view, and the transient state of gestures. */
export interface CanvasState {
  readonly view: View;
  readonly marquee: Box | null;
  readonly guides: readonly Guide[];
  /** Where the current tool would place an object; null: nowhere. */
  readonly placing: Point | null;
  /** Where keys use the current tool; null: the crosshair is hidden. */
  readonly crosshair: Point | null;
  /** Whether the panel that repeats the selection is open. */
  readonly isRepeating: boolean;
  /** Figures of a gesture in progress, beside places of the level. */
  readonly measures: readonly Measure[];
  /** What was said beside a place of the level; null: nothing. */
  readonly message: Measure | null;
  /** The open menu, and where it stands, in px of the screen; null: none. */
  readonly menu: { readonly screen: Point; readonly parts: readonly MenuPart[] } | null;
  /** CSS cursor */
  readonly cursor: string;
}

export function createCanvasState(): StoreApi<CanvasState> {
  return createStore<CanvasState>(() => ({
    view: { x: 0, y: 0, zoom: 1, width: 1, height: 1 },
    marquee: null,
    guides: [],
    placing: null,
    crosshair: null,
    isRepeating: false,
    measures: [],
    message: null,
    menu: null,
    cursor: 'default',
  }));
}

/** A line that shows what an object snapped to: at `at` px on one axis, from `from` to `to` on the other. */
export interface Guide {
  /** `x`: a vertical line at this x */
  readonly axis: 'x' | 'y';
  readonly at: number;
  readonly from: number;
  readonly to: number;
}

/** A figure or a message beside a place of the level. */
export interface Measure {
  readonly words: string;
  readonly at: Point;
}

/** An action in the menu of a place. */
export interface MenuAction {
  readonly title: string;
  /** The key, as it is displayed. */
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly run: () => void;
}

/** A menu within the menu. */
interface SubMenu {
  readonly title: string;
  readonly entries: readonly MenuAction[];
}

/** null is a line */
export type MenuPart = MenuAction | SubMenu | null;
