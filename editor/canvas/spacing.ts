import type { Box } from './view.ts';

type Axis = 'x' | 'y';

/** A free stretch between two boxes, px. */
export interface Gap {
  /** `x`: from left to right */
  readonly axis: Axis;
  readonly from: number;
  readonly to: number;
  /** where it lies on the other axis */
  readonly at: number;
}

export interface Spacing {
  /** px to move by on the axis, so that the gaps are equal */
  readonly by: number;
  /** The equal gaps, once it has moved. */
  readonly gaps: readonly Gap[];
}

/** px; a smaller gap is no gap */
const LEAST = 1;

const low = (box: Box, axis: Axis): number => (axis === 'x' ? box.left : box.top);
const high = (box: Box, axis: Axis): number => (axis === 'x' ? box.right : box.bottom);
const across = (axis: Axis): Axis => (axis === 'x' ? 'y' : 'x');

const overlaps = (a: Box, b: Box, axis: Axis): boolean => low(a, axis) <= high(b, axis) && high(a, axis) >= low(b, axis);

/** The nearest box before another on an axis, among those beside it; null: none. `reach`: px that they may overlap */
function before(own: Box, boxes: readonly Box[], axis: Axis, reach: number): Box | null {
  let best: Box | null = null;
  for (const box of boxes) {
    if (box === own || high(box, axis) > low(own, axis) + reach || !overlaps(own, box, across(axis))) continue;
    if (best === null || high(box, axis) > high(best, axis)) best = box;
  }
  return best;
}

function after(own: Box, boxes: readonly Box[], axis: Axis, reach: number): Box | null {
  let best: Box | null = null;
  for (const box of boxes) {
    if (box === own || low(box, axis) < high(own, axis) - reach || !overlaps(own, box, across(axis))) continue;
    if (best === null || low(box, axis) < low(best, axis)) best = box;
  }
  return best;
}

function gapBetween(first: Box, second: Box, axis: Axis): Gap {
  const other = across(axis);
  const from = Math.max(low(first, other), low(second, other));
  const to = Math.min(high(first, other), high(second, other));
  return { axis, from: high(first, axis), to: low(second, axis), at: (from + to) / 2 };
}

const sizeOf = ({ from, to }: Gap): number => to - from;

const shifted = (box: Box, axis: Axis, by: number): Box =>
  axis === 'x' ? { ...box, left: box.left + by, right: box.right + by } : { ...box, top: box.top + by, bottom: box.bottom + by };

/**
 * Where a box has the same gap to a neighbour as there is elsewhere: to the neighbours on both sides, or between a neighbour and
 * the next one.
 * @param own the moving box as the pointer has it
 * @param reach px within which it snaps
 */
export function equalSpacing(own: Box, boxes: readonly Box[], axis: Axis, reach: number): Spacing | null {
  const left = before(own, boxes, axis, reach);
  const right = after(own, boxes, axis, reach);
  const found: Spacing[] = [];
  const offer = (by: number, gapsOf: (moved: Box) => readonly Gap[]) => {
    if (Math.abs(by) > reach) return;
    const gaps = gapsOf(shifted(own, axis, by));
    if (gaps.every((gap) => sizeOf(gap) >= LEAST)) found.push({ by, gaps });
  };
  if (left !== null && right !== null) {
    const by = (low(right, axis) - high(own, axis) - (low(own, axis) - high(left, axis))) / 2;
    offer(by, (moved) => [gapBetween(left, moved, axis), gapBetween(moved, right, axis)]);
  }
  const farLeft = left === null ? null : before(left, boxes, axis, 0);
  if (left !== null && farLeft !== null) {
    const gap = gapBetween(farLeft, left, axis);
    offer(high(left, axis) + sizeOf(gap) - low(own, axis), (moved) => [gap, gapBetween(left, moved, axis)]);
  }
  const farRight = right === null ? null : after(right, boxes, axis, 0);
  if (right !== null && farRight !== null) {
    const gap = gapBetween(right, farRight, axis);
    offer(low(right, axis) - sizeOf(gap) - high(own, axis), (moved) => [gapBetween(moved, right, axis), gap]);
  }
  return found.reduce<Spacing | null>((best, one) => (best === null || Math.abs(one.by) < Math.abs(best.by) ? one : best), null);
}
