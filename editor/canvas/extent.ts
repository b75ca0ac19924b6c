import type { Box as HerBox } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf } from '../core/document/index.ts';
import type { Box, Point } from './view.ts';

/** The box around an object; the astronaut as she stands at the start. */
function boxOfObject(her: HerBox, found: FoundObject): Box {
  const boxes = boxesOf(her, found);
  return boxes.length === 1 ? boxes[0] : boxAroundAll(boxes);
}

/** The box of an object at one of its places. */
function boxAround({ halfWidth, halfHeight }: HerBox, found: FoundObject, { x, y }: Point): Box {
  const radius = radiusOf(found);
  if (radius !== null) return { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius };
  return { left: x - halfWidth, top: y - halfHeight, right: x + halfWidth, bottom: y + halfHeight };
}

/** The boxes of an object at each of its places. @param her the astronaut's box under the rules of the level */
export const boxesOf = (her: HerBox, found: FoundObject): readonly Box[] =>
  placesOf(found).map((place) => boxAround(her, found, place));

/**
 * The box around some objects, or around all of them if no keys are given; null for none.
 * @param her the astronaut's box under the rules of the level
 * @param only index of the one place of each object that counts; all of them if absent
 */
export function extentOf(file: LevelFile, her: HerBox, keys?: Iterable<ObjectKey>, only?: number): Box | null {
  const objects = objectsOf(file);
  const chosen = keys === undefined ? [...objects.values()] : [...keys].flatMap((key) => objects.get(key) ?? []);
  if (chosen.length === 0) return null;
  return boxAroundAll(chosen.map((found) => (only === undefined ? boxOfObject(her, found) : boxesOf(her, found)[only])));
}

function boxAroundAll(boxes: readonly Box[]): Box {
  let [left, top, right, bottom] = [
    Number.POSITIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  for (const box of boxes) {
    left = Math.min(left, box.left);
    top = Math.min(top, box.top);
    right = Math.max(right, box.right);
    bottom = Math.max(bottom, box.bottom);
  }
  return { left, top, right, bottom };
}
