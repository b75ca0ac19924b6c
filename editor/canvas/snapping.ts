import type { Box as HerBox } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type ObjectKey, objectsOf } from '../core/document/index.ts';
import type { Guide, Measure } from './canvas-state.ts';
import { boxesOf, extentOf } from './extent.ts';
import type { Box, Point } from './view.ts';

interface Snapped {
  /** px to move by instead of the pointer's motion */
  readonly dx: number;
  readonly dy: number;
  readonly guides: readonly Guide[];
  /** The sizes of equal gaps. */
  readonly measures: readonly Measure[];
}

export interface SnapOptions {
  /** px between grid lines; null: no grid */
  readonly grid: number | null;
  readonly toObjects: boolean;
  /** px of the level within which something snaps to another object */
  readonly reach: number;
  /** The axis along which nothing moves, as when a drag is kept straight; null: none. */
  readonly fixed?: 'x' | 'y' | null;
}

/** A line that others can snap to on one axis: its position, and its extent on the other axis. */
interface Line {
  readonly at: number;
  readonly from: number;
  readonly to: number;
}

const linesOfBox = ({ left, top, right, bottom }: Box, axis: 'x' | 'y'): Line[] => {
  const [low, high, from, to] = axis === 'x' ? [left, right, top, bottom] : [top, bottom, left, right];
  return [low, (low + high) / 2, high].map((at) => ({ at, from, to }));
};

/** What a drag may snap, and to what; computed when the drag begins. */
export interface SnapTargets {
  /** the box around the moving objects where they were when the drag began; null: nothing moves */
  readonly own: Box | null;
  /** the boxes of everything else */
  readonly boxes: readonly Box[];
  readonly x: readonly Line[];
  readonly y: readonly Line[];
}

interface SnapParts {
  /** Whether copies of the objects move: then the objects themselves are targets as well. */
  readonly areCopies?: boolean;
  /** Index of the only place of each object that moves; all of them if absent. */
  readonly only?: number | undefined;
}

/** The edges and centres of everything that does not move. @param her the astronaut's box under the rules of the level */
export function snapTargets(
  file: LevelFile,
  her: HerBox,
  moving: readonly ObjectKey[],
  { areCopies = false, only }: SnapParts = {},
): SnapTargets {
  const along: ReadonlySet<ObjectKey> = new Set(areCopies ? [] : moving);
  const boxes = [...objectsOf(file).values()].flatMap((found) => {
    if (!along.has(found.key)) return boxesOf(her, found);
    return only === undefined ? [] : boxesOf(her, found).filter((_, i) => i !== only);
  });
  const sorted = (axis: 'x' | 'y') => boxes.flatMap((box) => linesOfBox(box, axis)).sort((a, b) => a.at - b.at);
  return { own: extentOf(file, her, moving, only), boxes, x: sorted('x'), y: sorted('y') };
}

/** The line nearest to a value, by binary search: a drag of many objects among thousands asks often. */
function nearest(lines: readonly Line[], value: number): Line | null {
  let low = 0;
  let high = lines.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lines[middle].at < value) low = middle + 1;
    else high = middle;
  }
  const before = lines[low - 1];
  const after = lines[low];
  if (before === undefined) return after ?? null;
  if (after === undefined) return before;
  return value - before.at <= after.at - value ? before : after;
}

interface AxisSnap {
  readonly by: number;
  /** The extent of the line that was snapped to; null: nothing was snapped to. */
  readonly line: Line | null;
}

/** All lines at the same position, joined into one. */
function joined(lines: readonly Line[], { at }: Line): Line {
  let [from, to] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const line of lines) {
    if (line.at !== at) continue;
    from = Math.min(from, line.from);
    to = Math.max(to, line.to);
  }
  return { at, from, to };
}

function snapAxis(own: readonly Line[], lead: number, move: number, targets: readonly Line[], options: SnapOptions): AxisSnap {
  if (options.toObjects) {
    let best: { by: number; gap: number; line: Line } | null = null;
    for (const self of own) {
      const line = nearest(targets, self.at + move);
      if (line === null) continue;
      const gap = Math.abs(line.at - self.at - move);
      if (gap <= options.reach && (best === null || gap < best.gap)) best = { by: line.at - self.at, gap, line };
    }
    if (best !== null) return { by: best.by, line: joined(targets, best.line) };
  }
  if (options.grid === null) return { by: move, line: null };
  return { by: Math.round((lead + move) / options.grid) * options.grid - lead, line: null };
}

const STILL: AxisSnap = { by: 0, line: null };

/** The lines and figures of a gap. */
function ofGap({ axis, from, to, at }: Gap): { readonly guide: Guide; readonly measure: Measure } {
  const middle = (from + to) / 2;
  const words = `${Number((to - from).toFixed(2))} px`;
  // a gap from left to right is a horizontal line
  return axis === 'x'
    ? { guide: { axis: 'y', at, from, to }, measure: { words, at: { x: middle, y: at } } }
    : { guide: { axis: 'x', at, from, to }, measure: { words, at: { x: at, y: middle } } };
}

/**
 * Where a drag of objects goes: to edges and centres of other objects within reach or to where gaps are equal, whichever is
 * nearer, else to the grid.
 * @param lead the place of the grabbed object: its centre snaps to the grid
 */
export function snapMove(lead: Point, move: Point, targets: SnapTargets, options: SnapOptions): Snapped {
  const box = targets.own;
  if (box === null) return { dx: move.x, dy: move.y, guides: [], measures: [] };
  const aligned = {
    x: options.fixed === 'x' ? STILL : snapAxis(linesOfBox(box, 'x'), lead.x, move.x, targets.x, options),
    y: options.fixed === 'y' ? STILL : snapAxis(linesOfBox(box, 'y'), lead.y, move.y, targets.y, options),
  };
  const at = (dx: number, dy: number): Box => ({
    left: box.left + dx,
    top: box.top + dy,
    right: box.right + dx,
    bottom: box.bottom + dy,
  });
  /** Equal gaps, where they are nearer than what it aligns with. */
  const spacingOf = (axis: 'x' | 'y') => {
    if (!options.toObjects || options.fixed === axis) return null;
    const moved = axis === 'x' ? at(move.x, aligned.y.by) : at(aligned.x.by, move.y);
    const spacing = equalSpacing(moved, targets.boxes, axis, options.reach);
    const { line, by } = aligned[axis];
    return spacing !== null && (line === null || Math.abs(spacing.by) < Math.abs(by - move[axis])) ? spacing : null;
  };
  const spaced = { x: spacingOf('x'), y: spacingOf('y') };
  const dx = spaced.x === null ? aligned.x.by : move.x + spaced.x.by;
  const dy = spaced.y === null ? aligned.y.by : move.y + spaced.y.by;
  // A guide connects the moved box, at its new place, with what it is aligned with.
  const gaps = [...(spaced.x?.gaps ?? []), ...(spaced.y?.gaps ?? [])].map(ofGap);
  const guides: Guide[] = gaps.map(({ guide }) => guide);
  const add = (axis: 'x' | 'y', line: Line | null, from: number, to: number) => {
    if (line !== null) guides.push({ axis, at: line.at, from: Math.min(line.from, from), to: Math.max(line.to, to) });
  };
  if (spaced.x === null) add('x', aligned.x.line, box.top + dy, box.bottom + dy);
  if (spaced.y === null) add('y', aligned.y.line, box.left + dx, box.right + dx);
  return { dx, dy, guides, measures: gaps.map(({ measure }) => measure) };
}

type Axis = 'x' | 'y';

/** A free stretch between two boxes, px. */
interface Gap {
  /** `x`: from left to right */
  readonly axis: Axis;
  readonly from: number;
  readonly to: number;
  /** where it lies on the other axis */
  readonly at: number;
}

interface Spacing {
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
