import { OBJECT_LISTS } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { type ObjectKey, plainList } from '../objects.ts';

/** Deletes objects. The astronaut and the black hole stay: a level has exactly one of each. */
export function deleteObjects(keys: Iterable<ObjectKey>): Recipe {
  return (draft) => {
    const gone = new Set(keys);
    for (const list of OBJECT_LISTS) {
      const objects = plainList(draft, list);
      const left = objects.filter(({ id }) => id === undefined || !gone.has(id));
      if (left.length === objects.length) continue;
      if (left.length === 0) delete draft[list];
      else draft[list] = left as never;
    }
  };
}
