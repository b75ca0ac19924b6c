import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Guide } from './snapping.ts';
import type { Box, Point, View } from './view.ts';

/** What the canvas shows besides the level: of the person's doing, gone with the gesture. */
export interface CanvasState {
  readonly view: View;
  readonly marquee: Box | null;
  readonly guides: readonly Guide[];
  /** Where the tool in hand would place an object; null: nowhere. */
  readonly placing: Point | null;
  /** Where keys use the tool in hand; null: the crosshair is put away. */
  readonly crosshair: Point | null;
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
    cursor: 'default',
  }));
}
