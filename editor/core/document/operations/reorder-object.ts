import { OBJECT_LISTS } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { type ObjectKey, plainList } from '../objects.ts';

/**
 * Moves an object to another place in its list. The order matters: of asteroids at equal distance the first is the target, and
 * of overlapping fields the first acts.
 */
export function reorderObject(key: ObjectKey, index: number): Recipe {
  return (draft) => {
    for (const list of OBJECT_LISTS) {
      const objects = plainList(draft, list);
      const from = objects.findIndex(({ id }) => id === key);
      if (from < 0) continue;
      const others = objects.toSpliced(from, 1);
      draft[list] = others.toSpliced(Math.min(others.length, Math.max(0, index)), 0, objects[from]) as never;
    }
  };
}
