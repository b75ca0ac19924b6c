import {
  type FieldName,
  fieldsOf,
  isRequired,
  KINDS,
  type LevelFile,
  listOf,
  OBJECT_LISTS,
  type Placeable,
  placedAs,
  RULE_NAMES,
  type RuleName,
} from '../../../schema/index.ts';
import type { Recipe } from './edited-level.ts';
import { changeObjects, type ObjectKey, objectsOf, type PlacedObject, plainList, radiusOf, shifted } from './objects.ts';

/** distance of a new object's second place from the first, to the right, in radii: enough to grab each */
const BESIDE = 4;

/**
 * Adds an object at a place in px; its id is derived from its kind and place. @param radius px; by default the usual one of its
 * kind
 */
export function addObject(placeable: Placeable, x: number, y: number, radius?: number): Recipe {
  return (draft) => {
    const { kind, flag } = placedAs(placeable);
    const { places, radius: radiusField } = KINDS[kind];
    let size = 0;
    const written: [name: string, value: number | boolean][] = [];
    for (const [name, field] of fieldsOf(kind)) {
      if (field.type === 'flag') {
        if (name === flag) written.push([name, true]);
        continue;
      }
      const usual = isRequired(field) ? field.initial : undefined;
      const value = name === radiusField ? (radius ?? usual) : usual;
      if (name === radiusField) size = value ?? field.default ?? 0;
      if (value !== undefined || isRequired(field)) written.push([name, value ?? 0]);
    }
    const object = Object.fromEntries(written);
    for (const [i, [atX, atY]] of places.entries()) {
      object[atX] = x + BESIDE * size * i;
      object[atY] = y;
    }
    const list = listOf(kind);
    draft[list] = [...plainList(draft, list), object] as never;
  };
}

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

/**
 * Moves objects by px: a drag, or a nudge by keys.
 * @param only index of the only place of each object that moves; all of them if absent
 */
export function moveObjects(keys: Iterable<ObjectKey>, dx: number, dy: number, only?: number): Recipe {
  return (draft) => changeObjects(draft, keys, (object, _, kind) => shifted(kind, object, dx, dy, only));
}

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

/** Sets the radius of objects, px; the astronaut has none and is skipped. */
export function setRadius(keys: Iterable<ObjectKey>, radius: number): Recipe {
  const wanted = [...keys];
  return (draft) =>
    changeObjects(draft, wanted, (object, _, kind) => (KINDS[kind].radius === null ? object : { ...object, radius }));
}

/**
 * Scales radii by a factor, relative to `file`.
 * @param file the level before the gesture: radii in the draft may be absent
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

/** Sets a property of objects; undefined removes it. Refused if one of the objects can't have the property. */
export function setObjectProperty(keys: Iterable<ObjectKey>, property: FieldName, value: number | boolean | undefined): Recipe {
  return (draft) =>
    changeObjects(draft, keys, (object) => {
      const { [property as keyof typeof object]: _, ...others } = object;
      // keeps the order of the fields
      return (value === undefined ? others : { ...object, [property]: value }) as PlacedObject;
    });
}

// the level itself

/** Properties of the level itself that can be edited. */
export type LevelProperty = 'name' | 'description' | 'range' | 'recoil';

/** Sets a property of the level; undefined removes it, so that the default applies. */
export function setLevelProperty<P extends LevelProperty>(property: P, value: LevelFile[P]): Recipe {
  return (draft) => {
    if (value === undefined) delete draft[property];
    else draft[property] = value;
  };
}

type RulesOfFile = NonNullable<LevelFile['rules']>;

/** Sets a rule of the level; undefined removes it, so that the folder's rule or the game's default applies. */
export const setRule =
  (name: RuleName, value: number | undefined): Recipe =>
  (draft) => {
    const { [name]: _, ...others } = (draft.rules ?? {}) as RulesOfFile;
    put(draft, value === undefined ? others : { ...others, [name]: value });
  };

/** Removes all rules of the level; custom keys beside them stay. */
export const resetRules: Recipe = (draft) => {
  const kept = Object.entries(draft.rules ?? {}).filter(([key]) => !(RULE_NAMES as readonly string[]).includes(key));
  put(draft, Object.fromEntries(kept) as RulesOfFile);
};

function put(draft: LevelFile, rules: RulesOfFile): void {
  if (Object.keys(rules).length === 0) delete draft.rules;
  else draft.rules = rules;
}
