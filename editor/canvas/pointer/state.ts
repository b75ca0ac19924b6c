import type { StoreApi } from 'zustand/vanilla';
import type { Box as HerBox } from '../../../engine/index.ts';
import type { EditedLevel, ObjectKey, SelectionStore } from '../../document/index.ts';
import type { Tool } from '../../session/index.ts';
import type { CanvasState } from '../canvas-state.ts';
import type { SnapOptions } from '../snapping.ts';
import type { Point, View } from '../view.ts';

/** Whose hand it is: keys move the crosshair, which presses and drags as a pointer does. */
export type Device = 'mouse' | 'touch' | 'keys';

/** What the pointer does now. */
export interface PointerInput {
  /** px of screen from the canvas's top left */
  readonly screen: Point;
  /** px of the level */
  readonly place: Point;
  readonly shift: boolean;
  readonly alt: boolean;
  /** Ctrl, or the command key of a Mac: no snapping */
  readonly mod: boolean;
  readonly by: Device;
  /** 0 main, 1 middle, 2 second */
  readonly button: number;
}

/** What the states of the pointer may use. */
export interface PointerContext {
  readonly document: EditedLevel;
  /** The astronaut's box under the rules of the level. */
  her(): HerBox;
  readonly selection: SelectionStore;
  /** What the canvas shows for the pointer: marquee, guides. */
  readonly canvas: StoreApi<CanvasState>;
  /** The object that is pointed at. */
  readonly hovered: StoreApi<ObjectKey | null>;
  view(): View;
  setView(view: View): void;
  tool(): Tool;
  setTool(tool: Tool): void;
  snapping(): Omit<SnapOptions, 'reach'>;
  /** Says why a change was refused. */
  refused(message: string): void;
}

/** One thing that a pointer can be doing. Each handler returns the state that follows; nothing: it stays. */
export interface PointerState {
  readonly name: string;
  /** CSS cursor while it lasts */
  readonly cursor: string;
  move?(input: PointerInput): PointerState | undefined;
  up?(input: PointerInput): PointerState | undefined;
  /** Esc, a lost pointer, a second finger: what was begun is taken back. */
  cancel(): void;
}

/** A press that moves by less is a click, px of screen. */
export const CLICK_SLOP = { mouse: 3, touch: 8 } as const;

/** Whether the pointer has left where it was pressed. */
export function hasMoved(from: PointerInput, now: PointerInput): boolean {
  // keys don't tremble
  if (now.by === 'keys') return now.place.x !== from.place.x || now.place.y !== from.place.y;
  const slop = CLICK_SLOP[now.by];
  return Math.hypot(now.screen.x - from.screen.x, now.screen.y - from.screen.y) > slop;
}
