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

/**
 * State of a wormhole for a place to which she came other than by her own motion: at the start, or by another wormhole.
 * @param originX - x of the origin that the place is relative to, px
 * @param originY - y of that origin, px
 */
export function stateAt(mouths: IndexedCircles, wormhole: number, x: number, y: number, originX = 0, originY = 0): number {
  for (let mouth = 2 * wormhole; mouth <= 2 * wormhole + 1; mouth++) {
    const dx = x - (mouths.x[mouth] - originX);
    const dy = y - (mouths.y[mouth] - originY);
    if (dx * dx + dy * dy < mouths.r[mouth] * mouths.r[mouth]) return inMouth(mouth);
  }
  return OPEN;
}
