import { current, isDraft, original } from 'immer';
import {
  fieldsOf,
  KINDS,
  kindOfList,
  type LevelFile,
  OBJECT_KINDS,
  OBJECT_LISTS,
  type ObjectKind,
  type ObjectList,
  type Place,
  placesIn,
  SINGLE_KINDS,
  type SingleKind,
} from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';

/**
 * The key of an object: its id, or its kind for the objects that every level has exactly once, which have no id. No id begins
 * with @.
 */
export type ObjectKey = string;

const keyOf = (kind: SingleKind): ObjectKey => `@${kind}`;

export const ASTRONAUT = keyOf('astronaut');
export const BLACK_HOLE = keyOf('blackHole');

/** An object with the fields that all kinds have; `radius` is missing where the default applies, and for the astronaut. */
export interface PlacedObject {
  id?: string | undefined;
  x: number;
  y: number;
  radius?: number | undefined;
}

export interface FoundObject {
  readonly key: ObjectKey;
  readonly kind: ObjectKind;
  /** null for objects that a level has exactly once: the astronaut and the black hole */
  readonly list: ObjectList | null;
  /** index in its list; 0 without one */
  readonly index: number;
  /** as in the file; frozen */
  readonly object: PlacedObject;
  /** JSON pointer into the file */
  readonly pointer: string;
}

/** What was last found in each list, and singly: a drag makes a new file at each step, in which most objects are the same. */
const last = new Map<ObjectList, FoundObject[]>();
const lastSingle = new Map<SingleKind, FoundObject>();

/** An object that exists once, reused if it is as it was. */
function foundSingle(kind: SingleKind, object: PlacedObject): FoundObject {
  const before = lastSingle.get(kind);
  if (before?.object === object) return before;
  const found: FoundObject = { key: keyOf(kind), kind, list: null, index: 0, object, pointer: `/${kind}` };
  lastSingle.set(kind, found);
  return found;
}

/** The objects of a list, those that are as they were at the same index reused. */
function foundIn(list: ObjectList, objects: readonly PlacedObject[]): FoundObject[] {
  const before = last.get(list) ?? [];
  const kind = kindOfList(list);
  const all: FoundObject[] = [];
  for (const [index, object] of objects.entries()) {
    if (object.id === undefined) continue;
    const same = before[all.length];
    all.push(
      same?.object === object && same.index === index
        ? same
        : { key: object.id, kind, list, index, object, pointer: `/${list}/${index}` },
    );
  }
  last.set(list, all);
  return all;
}

/** All objects of a file by key: first the single ones, then the lists in file order. Computed once per file. */
export const objectsOf = keptWith((file: LevelFile): ReadonlyMap<ObjectKey, FoundObject> => {
  const objects = new Map<ObjectKey, FoundObject>();
  for (const kind of SINGLE_KINDS) {
    const found = foundSingle(kind, file[kind]);
    objects.set(found.key, found);
  }
  for (const list of OBJECT_LISTS) {
    for (const found of foundIn(list, file[list] ?? [])) objects.set(found.key, found);
  }
  return objects;
});

/** The key of the object that a JSON pointer leads to or into, for going to a problem; null if there is none. */
export function keyAt(file: LevelFile, pointer: string): ObjectKey | null {
  const [, part, index] = pointer.split('/');
  const single = SINGLE_KINDS.find((kind) => kind === part);
  if (single !== undefined) return keyOf(single);
  const list = OBJECT_LISTS.find((name) => name === part);
  return list === undefined ? null : (file[list]?.[Number(index)]?.id ?? null);
}

/** The file that a recipe is changing, as it was before. */
export const fileBefore = (draft: LevelFile): LevelFile => (isDraft(draft) ? (original(draft) as LevelFile) : draft);

/**
 * The current list of a file that a recipe is changing, without drafts, to be replaced as a whole. A thousand drafts would take
 * milliseconds.
 */
export function plainList(draft: LevelFile, list: ObjectList): readonly PlacedObject[] {
  const objects: PlacedObject[] = draft[list] ?? [];
  return isDraft(objects) ? current(objects) : objects;
}

/**
 * Replaces the objects with these keys by changed copies. Keys of objects that no longer exist are skipped.
 * @param change returns the changed copy, in which only numbers, texts and flags may be new; its argument is frozen
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
    // Immer searches everything that is not frozen for drafts: with a list of a thousand objects that would take milliseconds.
    draft[list] = Object.freeze(
      objects.map((object) =>
        object.id !== undefined && wanted.has(object.id) ? Object.freeze(change(object, object.id, kind)) : object,
      ),
    ) as never;
  }
}

type Numbers = Record<string, number>;

/** The places of an object: one for most kinds; for kinds with several, the first is its `x` and `y`. */
export const placesOf = ({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): readonly Place[] => placesIn(kind, object);

/**
 * A copy of an object with changed places.
 * @param change returns the new place
 * @param only index of the only place to change; all of them if absent
 */
export function withPlaces<T extends PlacedObject>(
  kind: ObjectKind,
  object: T,
  change: (place: Place, index: number) => Place,
  only?: number,
): T {
  const changed = { ...object };
  const numbers = changed as unknown as Numbers;
  for (const [i, [x, y]] of KINDS[kind].places.entries()) {
    if (only !== undefined && i !== only) continue;
    const place = change({ x: numbers[x], y: numbers[y] }, i);
    numbers[x] = place.x;
    numbers[y] = place.y;
  }
  return changed;
}

/** A copy of an object, moved by `dx`, `dy` px. @param only index of the only place to move; all of them if absent */
export const shifted = <T extends PlacedObject>(kind: ObjectKind, object: T, dx: number, dy: number, only?: number): T =>
  withPlaces(kind, object, ({ x, y }) => ({ x: x + dx, y: y + dy }), only);

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
