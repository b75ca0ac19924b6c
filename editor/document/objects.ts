import { current, isDraft } from 'immer';
import {
  kindOfList,
  type LevelFile,
  OBJECT_LISTS,
  type ObjectKind,
  type ObjectList,
  SINGLE_KINDS,
  type SingleKind,
} from '../../schema/index.ts';

/** Which object: its id, or the kind of one that every level has once and that has none. No id begins with @. */
export type ObjectKey = string;

const keyOf = (kind: SingleKind): ObjectKey => `@${kind}`;

export const ASTRONAUT = keyOf('astronaut');
export const BLACK_HOLE = keyOf('blackHole');

/** An object of a level with what all kinds have; `radius` is missing where a default stands for it, and on the astronaut. */
export interface PlacedObject {
  id?: string | undefined;
  x: number;
  y: number;
  radius?: number | undefined;
}

export interface FoundObject {
  readonly key: ObjectKey;
  readonly kind: ObjectKind;
  /** null where a level has exactly one: the astronaut and the black hole */
  readonly list: ObjectList | null;
  /** within its list; 0 without one */
  readonly index: number;
  /** as the file says it; frozen */
  readonly object: PlacedObject;
  /** JSON pointer into the file */
  readonly pointer: string;
}

const known = new WeakMap<LevelFile, ReadonlyMap<ObjectKey, FoundObject>>();

/** Every object of a file by its key: those that a level has once, then the lists in the order of the file. Made once a file. */
export function objectsOf(file: LevelFile): ReadonlyMap<ObjectKey, FoundObject> {
  const made = known.get(file);
  if (made !== undefined) return made;
  const objects = new Map<ObjectKey, FoundObject>();
  for (const kind of SINGLE_KINDS) {
    const key = keyOf(kind);
    objects.set(key, { key, kind, list: null, index: 0, object: file[kind], pointer: `/${kind}` });
  }
  for (const list of OBJECT_LISTS) {
    for (const [index, object] of (file[list] ?? []).entries()) {
      if (object.id === undefined) continue;
      const found = { key: object.id, kind: kindOfList(list), list, index, object, pointer: `/${list}/${index}` };
      objects.set(object.id, found);
    }
  }
  known.set(file, objects);
  return objects;
}

/** The key of the object that a JSON pointer leads to or into; null when it leads to none: to go to a problem. */
export function keyAt(file: LevelFile, pointer: string): ObjectKey | null {
  const [, part, index] = pointer.split('/');
  const single = SINGLE_KINDS.find((kind) => kind === part);
  if (single !== undefined) return keyOf(single);
  const list = OBJECT_LISTS.find((name) => name === part);
  return list === undefined ? null : (file[list]?.[Number(index)]?.id ?? null);
}

/** A list of a file that a recipe is changing, as it is now, without drafts: to be replaced as a whole. A thousand drafts would take milliseconds. */
export function plainList(draft: LevelFile, list: ObjectList): readonly PlacedObject[] {
  const objects: PlacedObject[] = draft[list] ?? [];
  return isDraft(objects) ? current(objects) : objects;
}

/**
 * Puts changed copies in the place of the objects with these keys. Keys of objects that are no longer there are passed over.
 * @param change gives the changed copy, in which only numbers, texts and flags are new; what it is given is frozen
 */
export function changeObjects(
  draft: LevelFile,
  keys: Iterable<ObjectKey>,
  change: (object: PlacedObject, key: ObjectKey, kind: ObjectKind) => PlacedObject,
): void {
  const wanted = new Set(keys);
  const plain = <T extends object>(object: T): T => (isDraft(object) ? (current(object as never) as T) : object);
  for (const kind of SINGLE_KINDS) {
    const key = keyOf(kind);
    if (!wanted.has(key)) continue;
    const object = plain<PlacedObject>(draft[kind]);
    const changed = change(object, key, kind);
    if (changed !== object) draft[kind] = changed as never;
  }
  for (const list of OBJECT_LISTS) {
    const objects = plainList(draft, list);
    const kind = kindOfList(list);
    if (!objects.some(({ id }) => id !== undefined && wanted.has(id))) continue;
    // immer walks through what is not frozen, in search of drafts: a list of a thousand would take milliseconds
    draft[list] = Object.freeze(
      objects.map((object) =>
        object.id !== undefined && wanted.has(object.id) ? Object.freeze(change(object, object.id, kind)) : object,
      ),
    ) as never;
  }
}
