import type { Scaling } from '../../core/document/index.ts';
import type { Box, Point } from '../view.ts';
import type { SelectionBox } from './box.ts';
import type { ScaleHandle } from './handles.ts';

/** A box can't be made smaller than this part of its size. */
const LEAST = 0.01;

export interface ScalingInput {
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
