import type { FieldName, LevelFile } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { changeObjects, type ObjectKey, type PlacedObject } from '../objects.ts';

/** Properties of the level itself that can be edited. */
export type LevelProperty = 'name' | 'description' | 'range' | 'recoil';

/** Sets a property of the level; undefined removes it, so that the default applies. */
export function setLevelProperty<P extends LevelProperty>(property: P, value: LevelFile[P]): Recipe {
  return (draft) => {
    if (value === undefined) delete draft[property];
    else draft[property] = value;
  };
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
