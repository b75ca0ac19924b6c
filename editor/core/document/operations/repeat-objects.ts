import { kindOfList, OBJECT_LISTS } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { groupsIn } from '../marks.ts';
import { fileBefore, type ObjectKey, plainList } from '../objects.ts';
import { shifted } from '../places.ts';
import { marksOfCopies } from './edit-marks.ts';
import { mappedObject, turnBy } from './transform-objects.ts';

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
export const stepOf = ({ copies, degrees }: { readonly copies: number; readonly degrees: number }): number =>
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
