import type { Level } from '../../../schema/index.ts';
import { circlesOf, type IndexedCircles, indexed } from '../../indexed-circles.ts';
import type { Scene } from '../../scene.ts';

/** All mouths of a scene: that of wormhole `w` at (x, y) is the disc 2 w, the one at (toX, toY) the disc 2 w + 1. */
export function mouthsOf(level: Level): IndexedCircles {
  const discs = level.wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);
  return indexed(circlesOf(discs, [...discs.keys()]));
}

/** Those of a compiled scene. */
export const preparedMouths = (scene: Scene): IndexedCircles => scene.own.wormholes as IndexedCircles;

/** The other mouth of the same wormhole. */
export const otherMouth = (mouth: number): number => mouth ^ 1;

/** No mouth of a wormhole counts as around her: it is open. */
export const OPEN = 0;

/** What the state of a wormhole is while she is in a mouth, and it doesn't fire. */
export const inMouth = (mouth: number): number => 1 + (mouth & 1);

/**
 * What the state of a wormhole is for her who is at a place without having come there by her own motion: at the start, or by another
 * wormhole.
 * @param originX, originY what the place is relative to, px
 */
export function stateAt(mouths: IndexedCircles, wormhole: number, x: number, y: number, originX = 0, originY = 0): number {
  for (let mouth = 2 * wormhole; mouth <= 2 * wormhole + 1; mouth++) {
    const dx = x - (mouths.x[mouth] - originX);
    const dy = y - (mouths.y[mouth] - originY);
    if (dx * dx + dy * dy < mouths.r[mouth] * mouths.r[mouth]) return inMouth(mouth);
  }
  return OPEN;
}
