import { HALF_HEIGHT, HALF_WIDTH } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, radiusOf } from '../document/index.ts';
import type { Box } from './view.ts';

/** What an object covers; the astronaut as she stands at the start. */
export function boxOf(found: FoundObject): Box {
  const { x, y } = found.object;
  const radius = radiusOf(found);
  const width = radius ?? HALF_WIDTH;
  const height = radius ?? HALF_HEIGHT;
  return { left: x - width, top: y - height, right: x + width, bottom: y + height };
}

/** The box around these objects; around all of them when no keys are given; null for none. */
export function extentOf(file: LevelFile, keys?: Iterable<ObjectKey>): Box | null {
  const objects = objectsOf(file);
  const chosen = keys === undefined ? [...objects.values()] : [...keys].flatMap((key) => objects.get(key) ?? []);
  if (chosen.length === 0) return null;
  let [left, top, right, bottom] = [
    Number.POSITIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  for (const found of chosen) {
    const box = boxOf(found);
    left = Math.min(left, box.left);
    top = Math.min(top, box.top);
    right = Math.max(right, box.right);
    bottom = Math.max(bottom, box.bottom);
  }
  return { left, top, right, bottom };
}
