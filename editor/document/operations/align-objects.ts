import type { LevelFile } from '../../../schema/index.ts';
import type { Recipe } from '../document.ts';
import { changeObjects, type FoundObject, type ObjectKey, objectsOf } from '../objects.ts';
import { radiusOf } from './resize-objects.ts';

export const EDGES = ['left', 'centre', 'right', 'top', 'middle', 'bottom'] as const;
/** Which edge is brought into line: centre is left to right, middle is top to bottom. */
export type Edge = (typeof EDGES)[number];
export type Axis = 'x' | 'y';

const AXIS_OF: Record<Edge, Axis> = { left: 'x', centre: 'x', right: 'x', top: 'y', middle: 'y', bottom: 'y' };
const SIDE_OF: Record<Edge, -1 | 0 | 1> = { left: -1, centre: 0, right: 1, top: -1, middle: 0, bottom: 1 };

/** Half the width or height in px; she is a box of 20 x 32. */
const halfOf = (found: FoundObject, axis: Axis): number => radiusOf(found) ?? (axis === 'x' ? 10 : 16);

const chosen = (file: LevelFile, keys: Iterable<ObjectKey>): FoundObject[] =>
  [...keys].flatMap((key) => objectsOf(file).get(key) ?? []);

/** Brings one edge of all objects into line with the outermost of them. @param file the level as it is */
export function alignObjects(file: LevelFile, keys: Iterable<ObjectKey>, edge: Edge): Recipe {
  const axis = AXIS_OF[edge];
  const side = SIDE_OF[edge];
  const objects = chosen(file, keys);
  const low = Math.min(...objects.map((found) => found.object[axis] - halfOf(found, axis)));
  const high = Math.max(...objects.map((found) => found.object[axis] + halfOf(found, axis)));
  const line = side < 0 ? low : side > 0 ? high : (low + high) / 2;
  return place(axis, new Map(objects.map((found) => [found.key, line - side * halfOf(found, axis)])));
}

/** Spreads the centres evenly between the two outermost objects; fewer than three stay. @param file the level as it is */
export function distributeObjects(file: LevelFile, keys: Iterable<ObjectKey>, axis: Axis): Recipe {
  const objects = chosen(file, keys).sort((a, b) => a.object[axis] - b.object[axis]);
  const first = objects[0]?.object[axis];
  const step = objects.length < 3 ? 0 : (objects[objects.length - 1].object[axis] - first) / (objects.length - 1);
  const inner = objects.slice(1, -1);
  return place(axis, new Map(inner.map((found, i) => [found.key, first + (i + 1) * step])));
}

/** Puts objects at new places along one axis. */
const place =
  (axis: Axis, places: ReadonlyMap<ObjectKey, number>): Recipe =>
  (draft) =>
    changeObjects(draft, places.keys(), (object, key) => ({ ...object, [axis]: places.get(key) }));
