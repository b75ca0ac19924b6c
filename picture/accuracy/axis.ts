import { textWidth } from '../text.ts';
import type { Ink } from '../theme.ts';
import { num, polyline } from '../xml.ts';

/** A logarithmic axis over whole decades. */
interface LogAxis {
  /** Powers of ten at its ends. */
  readonly low: number;
  readonly high: number;
  /** The position of a value between `from` and `to`; values outside are clamped to the axis. */
  at(value: number): number;
}

/** Creates an axis for all positive values: at least one decade, and a default one when there are none. */
export function logAxis(values: readonly number[], from: number, to: number): LogAxis {
  const logs = values.filter((value) => value > 0 && Number.isFinite(value)).map(Math.log10);
  const low = logs.length === 0 ? -1 : Math.floor(Math.min(...logs) - 0.05);
  const high = logs.length === 0 ? 0 : Math.max(low + 1, Math.ceil(Math.max(...logs) + 0.05));
  return {
    low,
    high,
    at(value) {
      const log = value > 0 ? Math.min(high, Math.max(low, Math.log10(value))) : low;
      return from + ((log - low) / (high - low)) * (to - from);
    },
  };
}

/** The powers of ten to label, if there is room for about `room` labels. */
export function decades({ low, high }: LogAxis, room: number): number[] {
  const step = Math.max(1, Math.ceil((high - low) / room));
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step) + 1 }, (_, i) => first + i * step);
}

/** Formats a power of ten: 0.01, 1, 1,000; 1e-6 where that is shorter. */
export function powerOfTen(power: number): string {
  if (power >= 0 && power <= 4) return (10 ** power).toLocaleString('en-US');
  if (power < 0 && power >= -3) return (10 ** power).toFixed(-power);
  return `1e${power}`;
}

interface LabelBox {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** The place of a label. */
interface Label {
  /** The beginning of its baseline. */
  readonly x: number;
  readonly y: number;
  /** Whether a line should lead to its point, because the label is far from it. */
  readonly leader: boolean;
}

const overlap = (a: LabelBox, b: LabelBox): number =>
  Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
  Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

/**
 * Finds places for labels near their points, one after the other, where they cover as little as possible of the points and of
 * each other.
 * @param labels each with its point, and how far from it it begins at least
 * @param points all marks in the picture
 * @param within the labels stay inside this box
 */
export function placeLabels(
  labels: readonly {
    readonly text: string;
    readonly size: number;
    readonly from: number;
    readonly x: number;
    readonly y: number;
  }[],
  points: readonly (readonly [x: number, y: number])[],
  within: LabelBox,
): Label[] {
  const taken: LabelBox[] = points.map(([x, y]) => ({ left: x - 5, right: x + 5, top: y - 5, bottom: y + 5 }));
  return labels.map(({ text, size, from, x, y }) => {
    const width = textWidth(text, size);
    let best: { box: LabelBox; cost: number; far: boolean } | null = null;
    for (const reach of [11, 20, 32, 46, 62]) {
      if (reach < from) continue;
      for (const [dx, dy] of DIRECTIONS) {
        const left = dx > 0 ? x + dx * reach : dx < 0 ? x + dx * reach - width : x - width / 2;
        const middle = y + dy * reach;
        const box: LabelBox = {
          left: left - 3,
          right: left + width + 3,
          top: middle - size / 2 - 3,
          bottom: middle + size / 2 + 3,
        };
        const outside = Math.max(
          0,
          within.left - box.left,
          box.right - within.right,
          within.top - box.top,
          box.bottom - within.bottom,
        );
        const cost = 1000 * outside + 3 * reach + taken.reduce((sum, other) => sum + overlap(box, other), 0);
        if (best === null || cost < best.cost) best = { box, cost, far: reach > 20 };
      }
    }
    const { box, far } = best!;
    taken.push(box);
    return { x: box.left + 3, y: box.bottom - 3, leader: far };
  });
}

const DIRECTIONS = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [0.8, -0.8],
  [0.8, 0.8],
  [-0.8, -0.8],
  [-0.8, 0.8],
] as const;

/** What a line of a diagram stands for. Each has a mark of its own shape. */
export type LineKind = Extract<Ink, 'arcade' | 'euler' | 'verlet' | 'rk4' | 'taylor' | 'peer'>;

function outline(kind: LineKind, x: number, y: number, r: number): string {
  const corners = (count: number, first: number, inner: number): string =>
    polyline(
      Array.from({ length: count }, (_, i) => {
        const angle = first + (2 * Math.PI * i) / count;
        const reach = i % 2 === 1 ? inner : r;
        return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)] as const;
      }),
      true,
    );
  switch (kind) {
    case 'arcade':
      return corners(10, -Math.PI / 2, 0.45 * r);
    case 'euler':
      return corners(3, -Math.PI / 2, r);
    case 'verlet':
      return corners(4, Math.PI / 4, r);
    case 'rk4':
      return corners(4, 0, r);
    case 'taylor':
      return `M${num(x - 0.85 * r)} ${num(y)}a${num(0.85 * r)} ${num(0.85 * r)} 0 1 0 ${num(1.7 * r)} 0a${num(0.85 * r)} ${num(0.85 * r)} 0 1 0 ${num(-1.7 * r)} 0Z`;
    case 'peer':
      return corners(4, -Math.PI / 2, 0.5 * r);
  }
}

/**
 * Draws the mark of a line in `currentColor`.
 * @param r half its size
 * @param hollow whether it marks a failure
 */
export function drawMark(kind: LineKind, x: number, y: number, r: number, hollow: boolean): string {
  const fill = hollow ? 'fill="none" stroke="currentColor" stroke-width="1.3"' : 'fill="currentColor"';
  return `<path d="${outline(kind, x, y, r)}" ${fill} stroke-linejoin="round"/>`;
}

/** How the front and the lines to the axes are drawn. */
export const FRONT = 'stroke-width="7" stroke-linecap="round" stroke-linejoin="round" opacity="0.32"';
export const CROSS = 'stroke-width="1" stroke-dasharray="2 4"';

/** The sign of the best setting of a family: brackets around its mark. */
export function drawBest(x: number, y: number): string {
  const side = (sign: 1 | -1): string =>
    `M${num(x + 6 * sign)} ${num(y - 8)}L${num(x + 9 * sign)} ${num(y - 8)}L${num(x + 9 * sign)} ${num(y + 8)}L${num(x + 6 * sign)} ${num(y + 8)}`;
  return `<path d="${side(-1)}${side(1)}" fill="none" stroke="currentColor" stroke-width="1.8"/>`;
}

/** Where a diagram has what, in units of the picture. */
interface Layout {
  readonly width: number;
  readonly height: number;
  readonly plot: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number };
  readonly failed: { readonly left: number; readonly right: number };
  /** Null: the legend is a picture of its own, and there is no title. */
  readonly legend: { readonly left: number; readonly top: number } | null;
  /** Labels that an axis has room for. */
  readonly room: { readonly x: number; readonly y: number };
}

export const WIDE: Layout = {
  width: 960,
  height: 580,
  plot: { left: 84, top: 114, right: 664, bottom: 506 },
  failed: { left: 684, right: 772 },
  legend: { left: 796, top: 126 },
  room: { x: 8, y: 6 },
};

/** The layout for a place that is only so wide. */
export function narrowLayout(width: number, hasFailures: boolean): Layout {
  const right = width - (hasFailures ? 74 : 20);
  const bottom = 34 + Math.round(0.52 * width);
  return {
    width,
    height: bottom + 40,
    plot: { left: 48, top: 34, right, bottom },
    failed: { left: right + 10, right: width - 6 },
    legend: null,
    room: { x: Math.max(2, Math.floor((right - 48) / 44)), y: 5 },
  };
}
