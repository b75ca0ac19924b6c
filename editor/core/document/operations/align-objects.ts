import type { LevelFile } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { changeObjects, type FoundObject, type ObjectKey, objectsOf } from '../objects.ts';
import { placesOf, withPlaces } from '../places.ts';
import { radiusOf } from './resize-objects.ts';

export const EDGES = ['left', 'centre', 'right', 'top', 'middle', 'bottom'] as const;
/** The edge to align: centre is halfway from left to right, middle is halfway from top to bottom. */
export type Edge = (typeof EDGES)[number];
export type Axis = 'x' | 'y';

const AXIS_OF: Record<Edge, Axis> = { left: 'x', centre: 'x', right: 'x', top: 'y', middle: 'y', bottom: 'y' };
const SIDE_OF: Record<Edge, -1 | 0 | 1> = { left: -1, centre: 0, right: 1, top: -1, middle: 0, bottom: 1 };

/** The distances of its two edges and its middle from an object's first place, px; the astronaut counts as a box of 20 x 32. */
function reachOf(found: FoundObject, axis: Axis): Readonly<Record<-1 | 0 | 1, number>> {
  const half = radiusOf(found) ?? (axis === 'x' ? 10 : 16);
  const away = placesOf(found).map((place) => place[axis] - found.object[axis]);
  const [low, high] = [Math.min(...away) - half, Math.max(...away) + half];
  return { [-1]: low, 0: (low + high) / 2, 1: high };
}

const chosen = (file: LevelFile, keys: Iterable<ObjectKey>): FoundObject[] =>
  [...keys].flatMap((key) => objectsOf(file).get(key) ?? []);

/** Aligns one edge of all objects with the outermost one. @param file the current level */
export function alignObjects(file: LevelFile, keys: Iterable<ObjectKey>, edge: Edge): Recipe {
  const axis = AXIS_OF[edge];
  const side = SIDE_OF[edge];
  const objects = chosen(file, keys);
  const low = Math.min(...objects.map((found) => found.object[axis] + reachOf(found, axis)[-1]));
  const high = Math.max(...objects.map((found) => found.object[axis] + reachOf(found, axis)[1]));
  const line = side < 0 ? low : side > 0 ? high : (low + high) / 2;
  return place(axis, new Map(objects.map((found) => [found.key, line - reachOf(found, axis)[side]])));
}

/** Spreads the centres evenly between the two outermost objects; fewer than three stay. @param file the current level */
export function distributeObjects(file: LevelFile, keys: Iterable<ObjectKey>, axis: Axis): Recipe {
  const middleOf = (found: FoundObject): number => found.object[axis] + reachOf(found, axis)[0];
  const objects = chosen(file, keys).sort((a, b) => middleOf(a) - middleOf(b));
  if (objects.length < 3) return () => {};
  const first = middleOf(objects[0]);
  const step = (middleOf(objects[objects.length - 1]) - first) / (objects.length - 1);
  const inner = objects.slice(1, -1);
  return place(axis, new Map(inner.map((found, i) => [found.key, first + (i + 1) * step - reachOf(found, axis)[0]])));
}

/** Moves objects to new places along one axis. */
const place =
  (axis: Axis, places: ReadonlyMap<ObjectKey, number>): Recipe =>
  (draft) =>
    changeObjects(draft, places.keys(), (object, key, kind) => {
      const first = object[axis];
      const to = places.get(key) ?? first;
      // the first place goes exactly to its target, the others keep their distance from it
      return withPlaces(kind, object, (at, i) => ({ ...at, [axis]: i === 0 ? to : to + (at[axis] - first) }));
    });
