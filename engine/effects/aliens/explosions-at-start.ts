import type { IndexedCircles } from '../../indexed-circles.ts';

/** This many followers in the list are examined before the index is used: dense heaps are done sooner that way. */
const NEXT_IN_LIST = 32;

const NOBODY = new Int32Array(0);

/**
 * Finds the aliens that overlap at their places in the level. They explode at time 0, two by two: the first in the list that
 * overlaps another one, with the first of those, and so on.
 * @param originX - x of the origin that places are relative to when they are compared, px; the last digit can depend on it
 * @param originY - y of that origin, px
 * @returns two indices for each pair, in that order
 */
export function explosionsAtStart(aliens: IndexedCircles, originX: number, originY: number): Int32Array {
  const { count, x, y, r, spatial } = aliens;
  if (count < 2) return NOBODY;
  const gone = new Uint8Array(count);
  const pairs: number[] = [];
  const overlap = (i: number, j: number): boolean => {
    const reach = r[i] + r[j];
    const dx = x[i] - originX - (x[j] - originX);
    const dy = y[i] - originY - (y[j] - originY);
    return dx * dx + dy * dy < reach * reach;
  };
  const partnerOf = (i: number): number => {
    const soon = spatial === null ? count : Math.min(count, i + 1 + NEXT_IN_LIST);
    for (let j = i + 1; j < soon; j++) if (gone[j] === 0 && overlap(i, j)) return j;
    let first = -1;
    if (spatial === null) return first;
    for (const j of spatial.around(x[i], y[i], r[i])) {
      if (j >= soon && (first < 0 || j < first) && gone[j] === 0 && overlap(i, j)) first = j;
    }
    return first;
  };
  for (let i = 0; i < count; i++) {
    if (gone[i] === 1) continue;
    const j = partnerOf(i);
    if (j < 0) continue;
    gone[i] = 1;
    gone[j] = 1;
    pairs.push(i, j);
  }
  return Int32Array.from(pairs);
}
