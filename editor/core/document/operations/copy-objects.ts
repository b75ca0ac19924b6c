import { kindOfList, type LevelFile, OBJECT_LISTS, type ObjectList } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { groupsIn } from '../marks.ts';
import { fileBefore, type ObjectKey, type PlacedObject, plainList } from '../objects.ts';
import { shifted } from '../places.ts';
import { marksOfCopies } from './edit-marks.ts';

/** Objects for the clipboard: lists as in a level file, without ids. */
export type Clipping = { [list in ObjectList]?: PlacedObject[] };

/**
 * The objects as JSON text for the clipboard, as a part of a level file; null if none of them can be copied (a level has one
 * astronaut and one black hole).
 */
export function copyObjects(file: LevelFile, keys: Iterable<ObjectKey>): string | null {
  const wanted = new Set(keys);
  const rows: string[] = [];
  for (const list of OBJECT_LISTS) {
    const objects = (file[list] ?? []).filter(({ id }) => id !== undefined && wanted.has(id));
    if (objects.length === 0) continue;
    const lines = objects.map(({ id: _, ...rest }) => `    ${JSON.stringify(rest)}`);
    rows.push(`  "${list}": [\n${lines.join(',\n')}\n  ]`);
  }
  return rows.length === 0 ? null : `{\n${rows.join(',\n')}\n}\n`;
}

/** Copies objects to a place `dx`, `dy` px away. The copy of a whole group is a group of its own. */
export function duplicateObjects(keys: Iterable<ObjectKey>, dx: number, dy: number): Recipe {
  return (draft) => {
    const wanted = new Set(keys);
    const file = fileBefore(draft);
    const own = marksOfCopies(
      file,
      (group) =>
        groupsIn(file)
          .get(group)
          ?.every((key) => wanted.has(key)) === true,
    );
    for (const list of OBJECT_LISTS) {
      const objects = plainList(draft, list);
      const copies = objects
        .filter(({ id }) => id !== undefined && wanted.has(id))
        .map(({ id: _, ...rest }) => own(shifted(kindOfList(list), rest, dx, dy)));
      if (copies.length > 0) draft[list] = [...objects, ...copies] as never;
    }
  };
}
