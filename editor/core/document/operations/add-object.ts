import { fieldsOf, isRequired, KINDS, listOf, type Placeable, placedAs } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { plainList } from '../objects.ts';

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
