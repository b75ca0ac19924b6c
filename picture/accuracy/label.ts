import { textWidth } from '../text.ts';

interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** The place of a label. */
export interface Label {
  /** The beginning of its baseline. */
  readonly x: number;
  readonly y: number;
  /** Whether a line should lead to its point, because the label is far from it. */
  readonly leader: boolean;
}

const overlap = (a: Box, b: Box): number =>
  Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
  Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

/**
 * Finds places for labels near their points, one after the other, where they cover as little as possible of the points and of
 * each other.
 * @param points all marks in the picture
 * @param within the labels stay inside this box
 */
export function placeLabels(
  labels: readonly { readonly text: string; readonly size: number; readonly x: number; readonly y: number }[],
  points: readonly (readonly [x: number, y: number])[],
  within: Box,
): Label[] {
  const taken: Box[] = points.map(([x, y]) => ({ left: x - 5, right: x + 5, top: y - 5, bottom: y + 5 }));
  return labels.map(({ text, size, x, y }) => {
    const width = textWidth(text, size);
    let best: { box: Box; cost: number; far: boolean } | null = null;
    for (const reach of [11, 20, 32, 46, 62]) {
      for (const [dx, dy] of DIRECTIONS) {
        const left = dx > 0 ? x + dx * reach : dx < 0 ? x + dx * reach - width : x - width / 2;
        const middle = y + dy * reach;
        const box: Box = { left: left - 3, right: left + width + 3, top: middle - size / 2 - 3, bottom: middle + size / 2 + 3 };
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
