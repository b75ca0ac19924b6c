import { current, isDraft } from 'immer';
import { type LevelFile, OBJECT_LISTS } from '../../schema/index.ts';

export type ObjectList = (typeof OBJECT_LISTS)[number];

/** What an object is; a hot asteroid is an asteroid. */
export type ObjectKind = 'astronaut' | 'blackHole' | 'asteroid' | 'nova' | 'repulsor' | 'alien' | 'mineral';

/** Which object: its id, or one of the two that every level has once and that have none. No id begins with @. */
export type ObjectKey = string;
export const ASTRONAUT: ObjectKey = '@astronaut';
export const BLACK_HOLE: ObjectKey = '@blackHole';

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
  /** null for the astronaut and the black hole */
  readonly list: ObjectList | null;
  /** within its list; 0 for the two without a list */
  readonly index: number;
  /** as the file says it; frozen */
  readonly object: PlacedObject;
  /** JSON pointer into the file */
  readonly pointer: string;
}

export const KIND_OF_LIST = {
  asteroids: 'asteroid',
  novae: 'nova',
  repulsors: 'repulsor',
  aliens: 'alien',
  minerals: 'mineral',
} as const satisfies Record<ObjectList, ObjectKind>;

export const LIST_OF_KIND = {
  asteroid: 'asteroids',
  nova: 'novae',
  repulsor: 'repulsors',
  alien: 'aliens',
  mineral: 'minerals',
} as const satisfies Record<Exclude<ObjectKind, 'astronaut' | 'blackHole'>, ObjectList>;

const known = new WeakMap<LevelFile, ReadonlyMap<ObjectKey, FoundObject>>();

/** Every object of a file by its key: the astronaut, the black hole, then the lists in the order of the file. Made once a file. */
export function objectsOf(file: LevelFile): ReadonlyMap<ObjectKey, FoundObject> {
  const made = known.get(file);
  if (made !== undefined) return made;
  const objects = new Map<ObjectKey, FoundObject>();
  const single = (key: ObjectKey, kind: 'astronaut' | 'blackHole') =>
    objects.set(key, { key, kind, list: null, index: 0, object: file[kind], pointer: `/${kind}` });
  single(ASTRONAUT, 'astronaut');
  single(BLACK_HOLE, 'blackHole');
  for (const list of OBJECT_LISTS) {
    for (const [index, object] of (file[list] ?? []).entries()) {
      if (object.id === undefined) continue;
      const found = { key: object.id, kind: KIND_OF_LIST[list], list, index, object, pointer: `/${list}/${index}` };
      objects.set(object.id, found);
    }
  }
  known.set(file, objects);
  return objects;
}

/** The key of the object that a JSON pointer leads to or into; null when it leads to none: to go to a problem. */
export function keyAt(file: LevelFile, pointer: string): ObjectKey | null {
  const [, part, index] = pointer.split('/');
  if (part === 'astronaut') return ASTRONAUT;
  if (part === 'blackHole') return BLACK_HOLE;
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
  change: (object: PlacedObject, key: ObjectKey) => PlacedObject,
): void {
  const wanted = new Set(keys);
  const plain = <T extends object>(object: T): T => (isDraft(object) ? (current(object as never) as T) : object);
  if (wanted.has(ASTRONAUT)) draft.astronaut = change(plain(draft.astronaut), ASTRONAUT);
  if (wanted.has(BLACK_HOLE)) draft.blackHole = change(plain(draft.blackHole), BLACK_HOLE);
  for (const list of OBJECT_LISTS) {
    const objects = plainList(draft, list);
    if (!objects.some(({ id }) => id !== undefined && wanted.has(id))) continue;
    // immer walks through what is not frozen, in search of drafts: a list of a thousand would take milliseconds
    draft[list] = Object.freeze(
      objects.map((object) =>
        object.id !== undefined && wanted.has(object.id) ? Object.freeze(change(object, object.id)) : object,
      ),
    ) as never;
  }
}
