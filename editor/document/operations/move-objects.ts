import type { Recipe } from '../document.ts';
import { changeObjects, type ObjectKey } from '../objects.ts';
import { shifted } from '../places.ts';

/**
 * Moves objects by so many px: a drag, or a nudge by keys.
 * @param only index of the one of their places that is moved; all of them when left out
 */
export function moveObjects(keys: Iterable<ObjectKey>, dx: number, dy: number, only?: number): Recipe {
  return (draft) => changeObjects(draft, keys, (object, _, kind) => shifted(kind, object, dx, dy, only));
}
