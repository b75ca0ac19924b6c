import { KINDS, type LevelFile } from '../../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf } from '../../core/document/index.ts';

/** An object that a change moved, resized or deleted. */
export interface ChangedObject {
  readonly key: ObjectKey;
  readonly was: FoundObject;
  /** null: it was deleted */
  readonly is: FoundObject | null;
}

function looksOther(was: FoundObject, is: FoundObject): boolean {
  if (was.kind !== is.kind || (KINDS[was.kind].radius !== null && was.object.radius !== is.object.radius)) return true;
  const then = placesOf(was);
  return placesOf(is).some(({ x, y }, i) => x !== then[i]?.x || y !== then[i]?.y);
}

/** The objects whose outlines differ between two states of a level. Objects that the files share are compared by reference. */
export function changedObjects(before: LevelFile, after: LevelFile): ChangedObject[] {
  const now = objectsOf(after);
  const changed: ChangedObject[] = [];
  for (const [key, was] of objectsOf(before)) {
    const is = now.get(key) ?? null;
    if (is === null || (is.object !== was.object && looksOther(was, is))) changed.push({ key, was, is });
  }
  return changed;
}
