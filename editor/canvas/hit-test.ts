import type { Box as HerBox } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type FoundObject, grabbableIn, type ObjectKey, placesOf, radiusOf } from '../core/document/index.ts';
import { boxesOf } from './extent.ts';
import type { Box, Point } from './view.ts';

export interface Hit {
  readonly key: ObjectKey;
  /** The index of the place, for objects with several. */
  readonly place: number;
  /** `rim`: dragging changes the radius */
  readonly part: 'body' | 'rim';
}

/** The input device; keys move the crosshair, which presses and drags like a pointer. */
export type Device = 'mouse' | 'touch' | 'keys';

/** px of screen from an object within which a pointer grabs it */
export const REACH: Readonly<Record<Device, number>> = { mouse: 5, touch: 18, keys: 5 };

/** With more selected objects than this, none can be resized by its rim: a drag is more likely meant to move them. */
const MOST_RESIZED = 12;

/**
 * The selected objects that can be resized by their rims: only a few, neither locked nor hidden, and each large enough on the
 * screen to tell its rim from its middle.
 * @param reach px of the level
 */
export function resizedByRim(file: LevelFile, selected: readonly ObjectKey[], reach: number): FoundObject[] {
  if (selected.length > MOST_RESIZED) return [];
  const objects = grabbableIn(file);
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

/** An object at a point of the level. */
interface Body {
  readonly hit: Hit;
  /** px; of several objects the smallest is meant, so that objects in a field stay reachable */
  readonly size: number;
  /** Whether the point is beside it, within reach. */
  readonly isBeside: boolean;
  /** Its place in the file: what is drawn later lies above. */
  readonly order: number;
}

/** Objects that contain the point come before those beside it, small ones before large ones, upper ones before lower ones. */
const byNearness = (a: Body, b: Body): number => Number(a.isBeside) - Number(b.isBeside) || a.size - b.size || b.order - a.order;

/**
 * All objects at a point of the level, the one that a click means first.
 * @param objects those that count
 * @param her the astronaut's box under the rules of the level
 * @param reach px of the level
 */
export function hitsAt(objects: Iterable<FoundObject>, her: HerBox, place: Point, reach: number): Hit[] {
  const bodies: Body[] = [];
  let order = 0;
  for (const found of objects) {
    const radius = radiusOf(found);
    let nearest: { readonly place: number; readonly outside: number } | null = null;
    for (const [i, at] of placesOf(found).entries()) {
      const outside = distanceOutside(radius, her, at, place);
      if (outside <= reach && (nearest === null || outside < nearest.outside)) nearest = { place: i, outside };
    }
    order++;
    if (nearest === null) continue;
    const hit: Hit = { key: found.key, place: nearest.place, part: 'body' };
    bodies.push({ hit, size: radius ?? her.halfHeight, isBeside: nearest.outside > 0, order });
  }
  return bodies.sort(byNearness).map(({ hit }) => hit);
}

/** The rim at a point, of the objects that can be resized by it; null: none. */
function rimAt(objects: readonly FoundObject[], her: HerBox, place: Point, reach: number): Hit | null {
  let best: { readonly hit: Hit; readonly gap: number } | null = null;
  for (const found of objects) {
    const radius = radiusOf(found);
    if (radius === null) continue;
    for (const [i, at] of placesOf(found).entries()) {
      const outside = distanceOutside(radius, her, at, place);
      const gap = Math.abs(outside);
      // a small object must keep a middle to move it by
      if (outside > reach || outside <= -Math.min(reach, radius / 2) || (best !== null && gap >= best.gap)) continue;
      best = { hit: { key: found.key, place: i, part: 'rim' }, gap };
    }
  }
  return best?.hit ?? null;
}

/**
 * What a press at a point of the level grabs: the rim of a selected object, or an object that is neither locked nor hidden.
 * @param her the astronaut's box under the rules of the level
 * @param reach px of the level
 */
export function hitTest(file: LevelFile, her: HerBox, place: Point, reach: number, selected: readonly ObjectKey[]): Hit | null {
  const rim = rimAt(resizedByRim(file, selected, reach), her, place, reach);
  return rim ?? hitsAt(grabbableIn(file).values(), her, place, reach)[0] ?? null;
}

/** The objects that a marquee selects: all that overlap it and are neither locked nor hidden. @param her the astronaut's box under the rules of the level */
export function objectsIn(file: LevelFile, her: HerBox, marquee: Box): ObjectKey[] {
  const caught: ObjectKey[] = [];
  for (const found of grabbableIn(file).values()) {
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
