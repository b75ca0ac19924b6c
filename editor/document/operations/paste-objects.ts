import { kindOfList, LEVEL_VERSION, OBJECT_LISTS, readLevel, SINGLE_KINDS } from '../../../schema/index.ts';
import { strictJson } from '../../../schema/json/index.ts';
import type { Recipe } from '../edited-level.ts';
import { fileBefore, type PlacedObject, plainList } from '../objects.ts';
import { placesOf, shifted } from '../places.ts';
import type { Refusal } from '../settle.ts';
import type { Clipping } from './copy-objects.ts';
import { marksOfCopies } from './edit-marks.ts';

export type ClippingReading =
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
