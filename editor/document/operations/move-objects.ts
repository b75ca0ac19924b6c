import type { Recipe } from '../document.ts';
import { changeObjects, type ObjectKey } from '../objects.ts';

/** Moves objects by so many px: a drag, or a nudge by keys. */
export function moveObjects(keys: Iterable<ObjectKey>, dx: number, dy: number): Recipe {
  return (draft) => changeObjects(draft, keys, (object) => ({ ...object, x: object.x + dx, y: object.y + dy }));
}
