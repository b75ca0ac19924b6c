import type { Level } from '../../../schema/basics/index.ts';
import { circlesOf, type IndexedCircles, indexed } from '../../indexed-circles.ts';
import type { Scene } from '../../scene.ts';
import type { Indexing } from '../../spatial-index.ts';

/** All mouths of a scene, as discs: the mouth of wormhole `w` at (x, y) is disc 2 w, the one at (toX, toY) is disc 2 w + 1. */
export function mouthsOf(level: Level, indexing: Indexing): IndexedCircles {
  const discs = level.wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);
  return indexed(circlesOf(discs, [...discs.keys()]), indexing);
}

/** The mouths that `prepare` made for a compiled scene. */
export const preparedMouths = (scene: Scene): IndexedCircles => scene.own.wormholes as IndexedCircles;

/** The other mouth of the same wormhole. */
export const otherMouth = (mouth: number): number => mouth ^ 1;

/** State of a wormhole that is open: neither of its mouths counts as containing her. */
export const OPEN = 0;

/** State of a wormhole while she is in a mouth, so that it does not fire. */
export const inMouth = (mouth: number): number => 1 + (mouth & 1);

/** Margin of a place on a rim in addition to the rounding of coordinates, px: the rounding of the time at which she came there. */
const LATE = 1e-12;

/** Relative rounding of a place on a rim: it was computed from both mouths and from the way to the first. */
const ROUNDING = 1e-14;

/**
 * State of a wormhole for her place, if she came there other than by her own motion or has just been in a mouth of it.
 * @param originX - x of the origin that the place is relative to, px
 * @param originY - y of that origin, px
 * @param late - how far from a rim she may be and still count as inside, in addition to rounding, px; null if only what contains
 * her counts. A wormhole puts her on the rim of its other mouth, and other mouths may have the same rim
 */
export function stateAt(
  { x, y, r }: IndexedCircles,
  wormhole: number,
  atX: number,
  atY: number,
  originX: number,
  originY: number,
  late: number | null,
): number {
  for (let mouth = 2 * wormhole; mouth <= 2 * wormhole + 1; mouth++) {
    const cx = x[mouth] - originX;
    const cy = y[mouth] - originY;
    const far = Math.abs(cx) + Math.abs(cy) + Math.abs(atX) + Math.abs(atY) + r[mouth];
    const within = r[mouth] + (late === null ? 0 : late + LATE + ROUNDING * far);
    if ((atX - cx) * (atX - cx) + (atY - cy) * (atY - cy) < within * within) return inMouth(mouth);
  }
  return OPEN;
}
