import { fieldsOf, KINDS, type LevelFile, LIMITS, type ObjectKind, type Place } from '../../../schema/index.ts';
import type { Recipe } from './edited-level.ts';
import { nameOf } from './marks.ts';
import {
  changeObjects,
  type FoundObject,
  type ObjectKey,
  objectsOf,
  type PlacedObject,
  placesOf,
  radiusOf,
  withPlaces,
} from './objects.ts';

/** A linear map: x to `(xx, xy)`, y to `(yx, yy)`. */
export interface LinearMap {
  readonly xx: number;
  readonly xy: number;
  readonly yx: number;
  readonly yy: number;
}

/** results are rounded to this part of a px, or of a unit of a vector */
const GRAIN = 0.01;

const round = (value: number): number => Number((Math.round(value / GRAIN) * GRAIN).toFixed(2)) + 0;

const QUARTERS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/** A turn by degrees, clockwise on the screen; quarters are exact. */
export function turnBy(degrees: number): LinearMap {
  const quarter = degrees / 90;
  const radians = (degrees * Math.PI) / 180;
  const [cos, sin] = Number.isInteger(quarter) ? QUARTERS[((quarter % 4) + 4) % 4] : [Math.cos(radians), Math.sin(radians)];
  return { xx: cos, xy: sin, yx: -sin, yy: cos };
}

/** `x`: left and right are exchanged */
export const mirrorAlong = (axis: 'x' | 'y'): LinearMap => ({
  xx: axis === 'x' ? -1 : 1,
  xy: 0,
  yx: 0,
  yy: axis === 'y' ? -1 : 1,
});

const apply = ({ xx, xy, yx, yy }: LinearMap, x: number, y: number): Place => ({ x: xx * x + yx * y, y: xy * x + yy * y });

const about = (centre: Place, map: LinearMap, { x, y }: Place): Place => {
  const moved = apply(map, x - centre.x, y - centre.y);
  return { x: round(centre.x + moved.x), y: round(centre.y + moved.y) };
};

type Numbers = Record<string, number | undefined>;

const usual = (kind: ObjectKind, name: string): number => {
  const field = fieldsOf(kind).find(([key]) => key === name)?.[1];
  return field?.type === 'number' ? (field.default ?? 0) : 0;
};

/** The vectors of an object after a map, by their fields. */
function mappedVectors(kind: ObjectKind, object: PlacedObject, map: LinearMap): [name: string, value: number][] {
  const numbers = object as unknown as Numbers;
  return Object.values(KINDS[kind].vectors as Readonly<Record<string, readonly [string, string]>>).flatMap(([x, y]) => {
    const now = { x: numbers[x] ?? usual(kind, x), y: numbers[y] ?? usual(kind, y) };
    const then = apply(map, now.x, now.y);
    return [
      [x, round(then.x)],
      [y, round(then.y)],
    ] as [string, number][];
  });
}

/** Whether an object has a vector that turns with it, such as a velocity. */
export const hasDirection = (kind: ObjectKind, object: PlacedObject): boolean =>
  mappedVectors(kind, object, turnBy(0)).some(([, value]) => value !== 0);

/** A copy of an object after a turn or a mirroring about a centre: its places and vectors follow. */
export function mappedObject<T extends PlacedObject>(kind: ObjectKind, object: T, centre: Place, map: LinearMap): T {
  const moved = withPlaces(kind, object, (place) => about(centre, map, place));
  const numbers = moved as unknown as Numbers;
  for (const [name, value] of mappedVectors(kind, object, map)) {
    // what is left out stays so while the default applies
    if ((numbers[name] ?? usual(kind, name)) !== value) numbers[name] = value;
  }
  return moved;
}

/** Turns or mirrors objects about a centre. Places and vectors are rounded to 0.01. */
export const mapObjects =
  (keys: Iterable<ObjectKey>, centre: Place, map: LinearMap): Recipe =>
  (draft) =>
    changeObjects(draft, keys, (object, _, kind) => mappedObject(kind, object, centre, map));

/**
 * Why objects can't be turned or mirrored: a vector would be longer along an axis than it may be. null: they can.
 * @param file the level before it
 */
export function mapProblem(file: LevelFile, keys: Iterable<ObjectKey>, map: LinearMap): string | null {
  const objects = objectsOf(file);
  for (const key of keys) {
    const found = objects.get(key);
    if (found === undefined) continue;
    for (const [name, value] of mappedVectors(found.kind, found.object, map)) {
      const field = fieldsOf(found.kind).find(([key]) => key === name)?.[1];
      if (field?.type !== 'number' || (value >= field.least && value <= field.most)) continue;
      return `${nameOf(found)} would have ${field.label ?? name} ${value} ${field.unit}; ${field.most} is the most. Make it weaker first.`;
    }
  }
  return null;
}

export interface Scaling {
  /** What stays in place. */
  readonly from: Place;
  readonly x: number;
  readonly y: number;
  /** The factor of radii; 1: they stay. */
  readonly radii: number;
}

/** Scales the distances of objects from a point, and their radii. @param file the level before it: radii may be left out there */
export function scaleObjects(file: LevelFile, keys: Iterable<ObjectKey>, { from, x, y, radii }: Scaling): Recipe {
  const objects = objectsOf(file);
  return (draft) =>
    changeObjects(draft, keys, (object, key, kind) => {
      const scaled = withPlaces(kind, object, (place) => about(from, { xx: x, xy: 0, yx: 0, yy: y }, place));
      const found = objects.get(key);
      const radius = found === undefined || radii === 1 ? null : radiusOf(found);
      return radius === null ? scaled : { ...scaled, radius: Math.max(LIMITS.leastRadius, round(radius * radii)) };
    });
}

const EDGES = ['left', 'centre', 'right', 'top', 'middle', 'bottom'] as const;
/** The edge to align: centre is halfway from left to right, middle is halfway from top to bottom. */
export type Edge = (typeof EDGES)[number];
type Axis = 'x' | 'y';

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
