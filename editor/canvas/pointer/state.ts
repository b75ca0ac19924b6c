import type { StoreApi } from 'zustand/vanilla';
import type { Box as HerBox } from '../../../engine/index.ts';
import type { EditedLevel, ObjectKey, SelectionStore } from '../../core/document/index.ts';
import type { Tool } from '../../core/session/index.ts';
import type { CanvasState, Measure } from '../canvas-state.ts';
import type { Device, Hit } from '../hit-test.ts';
import type { SnapOptions } from '../snapping.ts';
import type { Point, View } from '../view.ts';

/** The current input of the pointer. */
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
  /** 0 main, 1 middle, 2 secondary */
  readonly button: number;
}

/** Where the last click was, and what it selected. */
export interface LastClick {
  /** px of the level */
  readonly place: Point;
  readonly isSingle: boolean;
  readonly hit: Hit;
  /** the selection after it; another one makes the next click a first one */
  readonly selected: readonly ObjectKey[];
}

/** What the states of the pointer may use. */
export interface PointerContext {
  readonly document: EditedLevel;
  /** The astronaut's box under the rules of the level. */
  her(): HerBox;
  readonly selection: SelectionStore;
  /** What the canvas shows for the pointer: marquee, guides. */
  readonly canvas: StoreApi<CanvasState>;
  /** The hovered object. */
  readonly hovered: StoreApi<ObjectKey | null>;
  view(): View;
  setView(view: View): void;
  tool(): Tool;
  setTool(tool: Tool): void;
  /** Whether the tool stays selected after an object was placed. */
  isToolLocked(): boolean;
  snapping(): Omit<SnapOptions, 'reach'>;
  /** The last click that selected something; null: none. */
  readonly clicks: StoreApi<LastClick | null>;
  /** Opens the menu of a place. @param screen px of screen from the canvas's top left */
  openMenu(place: Point, screen: Point): void;
  /** Shows figures of the gesture in progress; they are not read out. */
  measure(measures: readonly Measure[]): void;
  /** Says something beside a place, until the next press. */
  say(words: string, at: Point): void;
  /** Shows why a change was refused. */
  refused(message: string): void;
}

/** A state of the pointer. Each handler returns the next state; undefined: no change. */
export interface PointerState {
  readonly name: string;
  /** CSS cursor in this state */
  readonly cursor: string;
  move?(input: PointerInput): PointerState | undefined;
  up?(input: PointerInput): PointerState | undefined;
  /** Called on Esc, a lost pointer or a second finger: undoes what was begun. */
  cancel(): void;
}

/** px of screen; a press that moves less is a click */
export const CLICK_SLOP = { mouse: 3, touch: 8 } as const;

/** Whether the pointer has left the point where it was pressed. */
export function hasMoved(from: PointerInput, now: PointerInput): boolean {
  // keys are exact
  if (now.by === 'keys') return now.place.x !== from.place.x || now.place.y !== from.place.y;
  const slop = CLICK_SLOP[now.by];
  return Math.hypot(now.screen.x - from.screen.x, now.screen.y - from.screen.y) > slop;
}
