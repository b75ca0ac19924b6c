import { fieldsOf, KINDS, type LevelFile, OBJECT_KINDS, type ObjectKind } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { changeObjects, type FoundObject, type ObjectKey, objectsOf } from '../objects.ts';

/** the default radii, px; null for kinds whose radius is required */
const USUAL = Object.fromEntries(
  OBJECT_KINDS.map((kind) => {
    const field = fieldsOf(kind).find(([name]) => name === KINDS[kind].radius)?.[1];
    return [kind, field?.type === 'number' ? (field.default ?? null) : null];
  }),
) as Readonly<Record<ObjectKind, number | null>>;

/** The radius of an object in px, its default if the file has none; null for the astronaut, who is a box. */
export function radiusOf({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): number | null {
  return KINDS[kind].radius === null ? null : (object.radius ?? USUAL[kind]);
}

/** Sets the radius of objects, px; the astronaut has none and is skipped. */
export function setRadius(keys: Iterable<ObjectKey>, radius: number): Recipe {
  const wanted = [...keys];
  return (draft) =>
    changeObjects(draft, wanted, (object, _, kind) => (KINDS[kind].radius === null ? object : { ...object, radius }));
}

/**
 * Scales radii by a factor, relative to `file`.
 * @param file the level before the gesture: radii in the draft may be absent
 */
export function scaleRadius(file: LevelFile, keys: Iterable<ObjectKey>, factor: number): Recipe {
  const objects = objectsOf(file);
  const radii = new Map<ObjectKey, number>();
  for (const key of keys) {
    const found = objects.get(key);
    const radius = found === undefined ? null : radiusOf(found);
    if (radius !== null) radii.set(key, radius * factor);
  }
  return (draft) => changeObjects(draft, radii.keys(), (object, key) => ({ ...object, radius: radii.get(key) }));
}
