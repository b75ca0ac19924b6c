import {
  kindOfList,
  LEVEL_VERSION,
  type LevelFile,
  OBJECT_LISTS,
  type ObjectList,
  readLevel,
  SINGLE_KINDS,
} from '../../../schema/index.ts';
import { strictJson } from '../../../schema/json/index.ts';
import type { Recipe } from './edited-level.ts';
import { groupsIn, marksOfCopies } from './marks.ts';
import type { Refusal } from './normalize.ts';
import { fileBefore, type ObjectKey, type PlacedObject, placesOf, plainList, shifted } from './objects.ts';
import { mappedObject, turnBy } from './transform-objects.ts';

/** Objects for the clipboard: lists as in a level file, without ids. */
type Clipping = { [list in ObjectList]?: PlacedObject[] };

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

type ClippingReading =
  | { readonly ok: true; readonly clipping: Clipping; readonly count: number }
  | { readonly ok: false; readonly refusal: Refusal };

const NOTHING: Refusal = {
  message: 'the clipboard contains no objects of a level',
  hint: 'Copy objects in the editor, or the text of a level file.',
};

/** Reads the lists from what `copyObjects` wrote, or from a whole level file. */
export function readClipping(text: string): ClippingReading {
  const json = strictJson(text);
  if (!json.ok) return { ok: false, refusal: NOTHING };
  const { value } = json;
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return { ok: false, refusal: NOTHING };
  const lists = Object.fromEntries(OBJECT_LISTS.map((list) => [list, (value as Record<string, unknown>)[list]]));
  // the lists are checked as part of a level, so that problems are reported in the same words
  const singles = Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, { x: 0, y: 0 }]));
  const level = { version: LEVEL_VERSION, name: 'clipboard', ...singles, ...lists };
  const reading = readLevel(JSON.stringify(level));
  if (!reading.ok) {
    const [{ message, hint }] = reading.problems;
    return { ok: false, refusal: { message, hint } };
  }
  const clipping: Clipping = {};
  let count = 0;
  for (const list of OBJECT_LISTS) {
    const objects: readonly PlacedObject[] = reading.document.file[list] ?? [];
    if (objects.length === 0) continue;
    clipping[list] = objects.map(({ id: _, ...rest }) => rest);
    count += objects.length;
  }
  return count === 0 ? { ok: false, refusal: NOTHING } : { ok: true, clipping, count };
}

/** The middle of the clipping's places, px. */
export function middleOf(clipping: Clipping): { x: number; y: number } {
  const all = OBJECT_LISTS.flatMap((list) =>
    (clipping[list] ?? []).flatMap((object) => placesOf({ kind: kindOfList(list), object })),
  );
  const middle = (values: readonly number[]) => (Math.min(...values) + Math.max(...values)) / 2;
  return { x: middle(all.map(({ x }) => x)), y: middle(all.map(({ y }) => y)) };
}

/** Adds the objects of a clipping, moved by `dx`, `dy` px; they get new ids, and their groups free names. */
export function pasteObjects(clipping: Clipping, dx = 0, dy = 0): Recipe {
  return (draft) => {
    const own = marksOfCopies(fileBefore(draft), () => true);
    for (const list of OBJECT_LISTS) {
      const added = clipping[list]?.map((object) => own(shifted(kindOfList(list), object, dx, dy)));
      if (added !== undefined) draft[list] = [...plainList(draft, list), ...added] as never;
    }
  };
}

/** copies of one repetition at most */
export const MOST_COPIES = 500;

/** Where the copies of a repetition stand. */
export type Repetition =
  | {
      readonly along: 'line';
      /** number of copies, besides the originals */
      readonly copies: number;
      /** px from one copy to the next */
      readonly dx: number;
      readonly dy: number;
    }
  | {
      readonly along: 'circle';
      readonly copies: number;
      readonly centre: { readonly x: number; readonly y: number };
      /** The angle from the originals to the last copy, clockwise; 360 spreads all evenly over the whole circle. */
      readonly degrees: number;
    };

/** degrees from one copy of a circle to the next */
const stepOf = ({ copies, degrees }: { readonly copies: number; readonly degrees: number }): number =>
  Math.abs(degrees) % 360 === 0 ? degrees / (copies + 1) : degrees / copies;

/** Repeats objects along a line or around a centre, 500 times at most. Copies of a whole group form a group each. */
export function repeatObjects(keys: Iterable<ObjectKey>, how: Repetition): Recipe {
  return (draft) => {
    const wanted = new Set(keys);
    const file = fileBefore(draft);
    const isWhole = (group: string) =>
      groupsIn(file)
        .get(group)
        ?.every((key) => wanted.has(key)) === true;
    const taken = new Set<string>();
    const owns = Array.from({ length: Math.min(MOST_COPIES, how.copies) }, () => marksOfCopies(file, isWhole, taken));
    for (const list of OBJECT_LISTS) {
      const objects = plainList(draft, list);
      const originals = objects.filter(({ id }) => id !== undefined && wanted.has(id));
      if (originals.length === 0) continue;
      const kind = kindOfList(list);
      const copies = owns.flatMap((own, i) =>
        originals.map(({ id: _, ...rest }) =>
          own(
            how.along === 'line'
              ? shifted(kind, rest, (i + 1) * how.dx, (i + 1) * how.dy)
              : mappedObject(kind, rest, how.centre, turnBy((i + 1) * stepOf(how))),
          ),
        ),
      );
      draft[list] = [...objects, ...copies] as never;
    }
  };
}

/** Copies objects to a place `dx`, `dy` px away. The copy of a whole group is a group of its own. */
export const duplicateObjects = (keys: Iterable<ObjectKey>, dx: number, dy: number): Recipe =>
  repeatObjects(keys, { along: 'line', copies: 1, dx, dy });
