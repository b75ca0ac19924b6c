import type { Recipe } from '../edited-level.ts';
import { changeObjects, type ObjectKey } from '../objects.ts';
import { shifted } from '../places.ts';

/**
 * Moves objects by px: a drag, or a nudge by keys.
 * @param only index of the only place of each object that moves; all of them if absent
 */
export function moveObjects(keys: Iterable<ObjectKey>, dx: number, dy: number, only?: number): Recipe {
  return (draft) => changeObjects(draft, keys, (object, _, kind) => shifted(kind, object, dx, dy, only));
}
