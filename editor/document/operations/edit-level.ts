import type { FieldName, LevelFile } from '../../../schema/index.ts';
import type { Recipe } from '../document.ts';
import { changeObjects, type ObjectKey, type PlacedObject } from '../objects.ts';

/** Properties of the level itself that can be typed. */
export type LevelProperty = 'name' | 'description' | 'range' | 'recoil';

/** Sets a property of the level; undefined leaves it out, so that its default stands for it. */
export function setLevelProperty<P extends LevelProperty>(property: P, value: LevelFile[P]): Recipe {
  return (draft) => {
    if (value === undefined) delete draft[property];
    else draft[property] = value;
  };
}

/** Sets a property of objects; undefined leaves it out. A property that one of the objects doesn't have is refused. */
export function setObjectProperty(keys: Iterable<ObjectKey>, property: FieldName, value: number | boolean | undefined): Recipe {
  return (draft) =>
    changeObjects(draft, keys, (object) => {
      const { [property as keyof typeof object]: _, ...others } = object;
      // what is left keeps its order, and a value its place
      return (value === undefined ? others : { ...object, [property]: value }) as PlacedObject;
    });
}
