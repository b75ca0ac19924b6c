import { fieldsOf, KINDS, type LevelFile, LIMITS, type ObjectKind } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { nameOf } from '../names.ts';
import { changeObjects, type ObjectKey, objectsOf, type PlacedObject } from '../objects.ts';
import { withPlaces } from '../places.ts';
import { radiusOf } from './resize-objects.ts';

/** A point, px. */
interface Point {
  readonly x: number;
  readonly y: number;
}

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

const apply = ({ xx, xy, yx, yy }: LinearMap, x: number, y: number): Point => ({ x: xx * x + yx * y, y: xy * x + yy * y });

const about = (centre: Point, map: LinearMap, { x, y }: Point): Point => {
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
export function mappedObject<T extends PlacedObject>(kind: ObjectKind, object: T, centre: Point, map: LinearMap): T {
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
  (keys: Iterable<ObjectKey>, centre: Point, map: LinearMap): Recipe =>
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
  readonly from: Point;
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
