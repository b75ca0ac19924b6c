import { HALF_HEIGHT, HALF_WIDTH } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf } from '../document/index.ts';
import type { Box, Point } from './view.ts';

/** The box around all that an object covers; the astronaut as she stands at the start. */
export function boxOf(found: FoundObject): Box {
  const boxes = boxesOf(found);
  return boxes.length === 1 ? boxes[0] : boxAroundAll(boxes);
}

/** What an object covers around one of its places. */
function boxAround(found: FoundObject, { x, y }: Point): Box {
  const radius = radiusOf(found);
  const width = radius ?? HALF_WIDTH;
  const height = radius ?? HALF_HEIGHT;
  return { left: x - width, top: y - height, right: x + width, bottom: y + height };
}

/** What an object covers at each of its places. */
export const boxesOf = (found: FoundObject): readonly Box[] => placesOf(found).map((place) => boxAround(found, place));

/**
 * The box around these objects; around all of them when no keys are given; null for none.
 * @param only index of the one place of each that counts; all of them when left out
 */
export function extentOf(file: LevelFile, keys?: Iterable<ObjectKey>, only?: number): Box | null {
  const objects = objectsOf(file);
  const chosen = keys === undefined ? [...objects.values()] : [...keys].flatMap((key) => objects.get(key) ?? []);
  if (chosen.length === 0) return null;
  return boxAroundAll(chosen.map((found) => (only === undefined ? boxOf(found) : boxesOf(found)[only])));
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
