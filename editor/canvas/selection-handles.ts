import type { Scaling } from '../core/document/index.ts';
import type { SelectionBox } from './extent.ts';
import type { Device } from './hit-test.ts';
import { type Box, type Point, toScreen, type View } from './view.ts';

/** A side of the box that a handle moves: -1 the left or top one, 1 the right or bottom one, 0 neither. */
type Side = -1 | 0 | 1;

export interface ScaleHandle {
  readonly does: 'scale';
  readonly across: Side;
  readonly along: Side;
}

type Handle = ScaleHandle | { readonly does: 'turn' };

/** A handle that is grabbed, and the box that it belongs to. */
export interface Grip {
  readonly box: SelectionBox;
  readonly handle: Handle;
}

interface PlacedHandle {
  readonly handle: Handle;
  /** px of the level */
  readonly at: Point;
}

/** px of screen between the box and its objects, and from the box to the handle that turns it */
const AWAY = 14;
const STEM = 26;
/** px of screen at the top of the canvas that its tools take */
const TOOLS = 60;
/** px of screen from a handle within which it is grabbed */
const REACH: Readonly<Record<Device, number>> = { mouse: 7, touch: 22, keys: 7 };
/** px of screen: a smaller box has handles at its corners only */
const ROOM = 56;

const CORNERS: readonly (readonly [Side, Side])[] = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
];
const EDGES: readonly (readonly [Side, Side])[] = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
];

/** The box as drawn, somewhat larger than what is selected. @param zoom px of screen per px of the level */
export function drawnBox({ box: { left, top, right, bottom } }: SelectionBox, zoom: number): Box {
  const away = AWAY / zoom;
  return { left: left - away, top: top - away, right: right + away, bottom: bottom + away };
}

/** All handles of a box. The one that turns stands above it, or below it where the tools of the canvas would cover it. */
export function handlesOf(selection: SelectionBox, view: View): PlacedHandle[] {
  const { zoom } = view;
  const { left, top, right, bottom } = drawnBox(selection, zoom);
  const at = (across: Side, along: Side): Point => ({
    x: (left + right) / 2 + (across * (right - left)) / 2,
    y: (top + bottom) / 2 + (along * (bottom - top)) / 2,
  });
  const [above, below] = [top - STEM / zoom, bottom + STEM / zoom].map((y) => ({ x: (left + right) / 2, y }));
  const isCovered = toScreen(view, above).y < TOOLS && toScreen(view, below).y <= view.height;
  const turn: PlacedHandle = { handle: { does: 'turn' }, at: isCovered ? below : above };
  if (!selection.scales) return [turn];
  const edges = EDGES.filter(([across]) => (across === 0 ? right - left : bottom - top) * zoom >= ROOM);
  const scale = [...CORNERS, ...edges].map(
    ([across, along]): PlacedHandle => ({
      handle: { does: 'scale', across, along },
      at: at(across, along),
    }),
  );
  return [turn, ...scale];
}

/** The handle at a point of the level; null: none. */
export function handleAt(selection: SelectionBox | null, { x, y }: Point, view: View, by: Device): Handle | null {
  if (selection === null) return null;
  let best: { readonly handle: Handle; readonly apart: number } | null = null;
  for (const { handle, at } of handlesOf(selection, view)) {
    const apart = Math.hypot(x - at.x, y - at.y) * view.zoom;
    if (apart <= REACH[by] && (best === null || apart < best.apart)) best = { handle, apart };
  }
  return best?.handle ?? null;
}

/** CSS cursor over a handle */
export function cursorOf(handle: Handle): string {
  if (handle.does === 'turn') return 'grab';
  if (handle.across === 0) return 'ns-resize';
  if (handle.along === 0) return 'ew-resize';
  return handle.across === handle.along ? 'nwse-resize' : 'nesw-resize';
}

/** A box can't be made smaller than this part of its size. */
const LEAST = 0.01;

interface ScalingInput {
  /** px that the handle was moved by */
  readonly move: Point;
  /** Whether both axes scale alike; without effect at an edge. */
  readonly keepsShape: boolean;
  /** Whether radii scale too: by the factor of the corner; at an edge they stay. */
  readonly withRadii: boolean;
}

/** What stays in place: the opposite side, or the middle where the handle moves neither side. */
const opposite = (low: number, high: number, side: number): number => (side === 0 ? (low + high) / 2 : side > 0 ? low : high);

/** How far along one axis the box grows; a box without extent can't. */
const factor = (size: number, side: number, move: number): number =>
  side === 0 || size === 0 ? 1 : Math.max(LEAST, (size + side * move) / size);

/** What a drag of a handle does: the opposite side stays, and the dragged one follows the pointer. */
export function scalingOf(selection: SelectionBox, handle: ScaleHandle, { move, keepsShape, withRadii }: ScalingInput): Scaling {
  const { across, along } = handle;
  const isCorner = across !== 0 && along !== 0;
  // where radii stay, the outermost places follow the pointer; else the outermost rims
  const box: Box = withRadii && isCorner ? selection.box : selection.places;
  const [width, height] = [box.right - box.left, box.bottom - box.top];
  const from = { x: opposite(box.left, box.right, across), y: opposite(box.top, box.bottom, along) };
  const free = { x: factor(width, across, move.x), y: factor(height, along, move.y) };
  if (!isCorner) return { from, ...free, radii: 1 };
  if (!keepsShape && !withRadii) return { from, ...free, radii: 1 };
  // the pointer, projected on the diagonal
  const length = width * width + height * height;
  const common = length === 0 ? 1 : Math.max(LEAST, 1 + (across * move.x * width + along * move.y * height) / length);
  return { from, x: common, y: common, radii: withRadii ? common : 1 };
}
