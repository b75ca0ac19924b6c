import { DEFAULT_RADIUS, type LevelFile } from '../../../schema/index.ts';
import type { Recipe } from '../document.ts';
import { ASTRONAUT, changeObjects, type FoundObject, type ObjectKey, objectsOf } from '../objects.ts';

/** The radius an object has in px, its default when the file leaves it out; null for the astronaut, who is a box. */
export function radiusOf({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): number | null {
  if (kind === 'astronaut') return null;
  if (object.radius !== undefined) return object.radius;
  return kind === 'blackHole' || kind === 'alien' || kind === 'mineral' ? DEFAULT_RADIUS[kind] : null;
}

/** Gives objects a radius, px; the astronaut has none and is passed over. */
export function setRadius(keys: Iterable<ObjectKey>, radius: number): Recipe {
  const sized = [...keys].filter((key) => key !== ASTRONAUT);
  return (draft) => changeObjects(draft, sized, (object) => ({ ...object, radius }));
}

/**
 * Scales radii by a factor, each from what it is in `file`.
 * @param file the level as it was before: the draft may leave defaults out
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
