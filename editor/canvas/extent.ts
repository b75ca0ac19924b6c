import { boxOf, type Box as HerBox } from '../../engine/index.ts';
import { type LevelFile, rulesOf } from '../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf } from '../document/index.ts';
import type { Box, Point } from './view.ts';

/** The box around all that an object covers; the astronaut as she stands at the start. */
function boxOfObject(file: LevelFile, found: FoundObject): Box {
  const boxes = boxesOf(file, found);
  return boxes.length === 1 ? boxes[0] : boxAroundAll(boxes);
}

/** What an object covers around one of its places. */
function boxAround(file: LevelFile, found: FoundObject, { x, y }: Point): Box {
  const radius = radiusOf(found);
  if (radius !== null) return { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius };
  const { halfWidth, halfHeight } = herBoxIn(file);
  return { left: x - halfWidth, top: y - halfHeight, right: x + halfWidth, bottom: y + halfHeight };
}

/** The astronaut's box by the rules of a level. */
export const herBoxIn = (file: LevelFile): HerBox => boxOf(rulesOf(file));

/** What an object covers at each of its places. */
export const boxesOf = (file: LevelFile, found: FoundObject): readonly Box[] =>
  placesOf(found).map((place) => boxAround(file, found, place));

/**
 * The box around these objects; around all of them when no keys are given; null for none.
 * @param only index of the one place of each that counts; all of them when left out
 */
export function extentOf(file: LevelFile, keys?: Iterable<ObjectKey>, only?: number): Box | null {
  const objects = objectsOf(file);
  const chosen = keys === undefined ? [...objects.values()] : [...keys].flatMap((key) => objects.get(key) ?? []);
  if (chosen.length === 0) return null;
  return boxAroundAll(chosen.map((found) => (only === undefined ? boxOfObject(file, found) : boxesOf(file, found)[only])));
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
