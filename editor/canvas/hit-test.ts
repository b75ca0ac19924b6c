import type { Box as HerBox } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf } from '../document/index.ts';
import { boxesOf } from './extent.ts';
import type { Box, Point } from './view.ts';

export interface Hit {
  readonly key: ObjectKey;
  /** The index of the place, for objects with several. */
  readonly place: number;
  /** `rim`: dragging changes the radius */
  readonly part: 'body' | 'rim';
}

/** px of screen from an object within which a pointer grabs it */
export const REACH = { mouse: 5, touch: 18, keys: 5 } as const;

/** With more selected objects than this, none can be resized by its rim: a drag is more likely meant to move them. */
const MOST_RESIZED = 12;

/**
 * The selected objects that can be resized by their rims: only a few, and each large enough on the screen to tell its rim from
 * its middle.
 * @param reach px of the level
 */
export function resizedByRim(file: LevelFile, selected: readonly ObjectKey[], reach: number): FoundObject[] {
  if (selected.length > MOST_RESIZED) return [];
  const objects = objectsOf(file);
  return selected.flatMap((key) => {
    const found = objects.get(key);
    const radius = found === undefined ? null : radiusOf(found);
    return found === undefined || radius === null || 2 * radius < reach ? [] : [found];
  });
}

/** The distance of a point from an object at one of its places, px; negative inside. */
function distanceOutside(radius: number | null, her: HerBox, at: Point, { x, y }: Point): number {
  const dx = x - at.x;
  const dy = y - at.y;
  if (radius !== null) return Math.hypot(dx, dy) - radius;
  return Math.max(Math.abs(dx) - her.halfWidth, Math.abs(dy) - her.halfHeight);
}

/**
 * What lies at a point of the level. Only selected objects can be grabbed by the rim; of several bodies the smallest wins, so
 * that objects in a field stay reachable.
 * @param her the astronaut's box under the rules of the level
 * @param reach px of the level
 */
export function hitTest(file: LevelFile, her: HerBox, place: Point, reach: number, selected: readonly ObjectKey[]): Hit | null {
  const resizable = new Set(resizedByRim(file, selected, reach).map(({ key }) => key));
  let rim: { hit: Hit; gap: number } | null = null;
  let body: { hit: Hit; size: number; outside: boolean } | null = null;
  for (const found of objectsOf(file).values()) {
    const { key } = found;
    const radius = radiusOf(found);
    const size = radius ?? her.halfHeight;
    for (const [i, at] of placesOf(found).entries()) {
      const outside = distanceOutside(radius, her, at, place);
      if (outside > reach) continue;
      // a small object must keep a middle to move it by
      const onRim = radius !== null && outside > -Math.min(reach, radius / 2);
      const gap = Math.abs(outside);
      if (onRim && resizable.has(key) && (rim === null || gap < rim.gap)) rim = { hit: { key, place: i, part: 'rim' }, gap };
      const better = body === null || (body.outside && outside <= 0) || (body.outside === outside > 0 && size <= body.size);
      if (better) body = { hit: { key, place: i, part: 'body' }, size, outside: outside > 0 };
    }
  }
  return rim?.hit ?? body?.hit ?? null;
}

/** The objects that a marquee selects: all that overlap it. @param her the astronaut's box under the rules of the level */
export function objectsIn(file: LevelFile, her: HerBox, marquee: Box): ObjectKey[] {
  const caught: ObjectKey[] = [];
  for (const found of objectsOf(file).values()) {
    const radius = radiusOf(found);
    if (boxesOf(her, found).some((box) => isCaught(box, radius, marquee))) caught.push(found.key);
  }
  return caught;
}

/** @param box around the object at one of its places */
function isCaught(box: Box, radius: number | null, { left, top, right, bottom }: Box): boolean {
  if (box.right < left || box.left > right || box.bottom < top || box.top > bottom) return false;
  const x = (box.left + box.right) / 2;
  const y = (box.top + box.bottom) / 2;
  // the corners of a circle's box do not belong to the circle
  const dx = x - Math.min(right, Math.max(left, x));
  const dy = y - Math.min(bottom, Math.max(top, y));
  return radius === null || dx * dx + dy * dy <= radius * radius;
}
