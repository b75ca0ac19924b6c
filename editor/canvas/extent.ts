import type { Box as HerBox } from '../../engine/index.ts';
import { KINDS, type LevelFile } from '../../schema/index.ts';
import {
  type FoundObject,
  grabbableIn,
  hasDirection,
  type ObjectKey,
  objectsOf,
  placesOf,
  radiusOf,
  unlocked,
} from '../core/document/index.ts';
import type { Box, Point } from './view.ts';

/**
 * The box around some objects, or around all of them if no keys are given; null for none.
 * @param her the astronaut's box under the rules of the level
 * @param only index of the one place of each object that counts; all of them if absent
 */
export function extentOf(file: LevelFile, her: HerBox, keys?: Iterable<ObjectKey>, only?: number): Box | null {
  const objects = objectsOf(file);
  const chosen = keys === undefined ? [...objects.values()] : [...keys].flatMap((key) => objects.get(key) ?? []);
  if (chosen.length === 0) return null;
  return boxAroundAll(chosen.flatMap((found) => (only === undefined ? boxesOf(her, found) : [boxesOf(her, found)[only]])));
}

/** The boxes of an object at each of its places. @param her the astronaut's box under the rules of the level */
export const boxesOf = (her: HerBox, found: FoundObject): readonly Box[] =>
  placesOf(found).map((place) => boxAround(her, found, place));

/** The box of an object at one of its places. */
function boxAround({ halfWidth, halfHeight }: HerBox, found: FoundObject, { x, y }: Point): Box {
  const radius = radiusOf(found);
  if (radius !== null) return { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius };
  return { left: x - halfWidth, top: y - halfHeight, right: x + halfWidth, bottom: y + halfHeight };
}

/** The box around some boxes, at least one. */
function boxAroundAll(boxes: readonly Box[]): Box {
  const far = Number.POSITIVE_INFINITY;
  let [left, top, right, bottom] = [far, far, -far, -far];
  for (const box of boxes) {
    left = Math.min(left, box.left);
    top = Math.min(top, box.top);
    right = Math.max(right, box.right);
    bottom = Math.max(bottom, box.bottom);
  }
  return { left, top, right, bottom };
}

export const centreOf = ({ left, top, right, bottom }: Box): Point => ({ x: (left + right) / 2, y: (top + bottom) / 2 });

/** The box around what is selected, whose handles scale and turn it. */
export interface SelectionBox {
  /** The objects that it changes: locked and hidden ones stay. */
  readonly keys: readonly ObjectKey[];
  readonly box: Box;
  /** The box around the places alone, without radii. */
  readonly places: Box;
  /** Whether there are handles to scale it; a single object with a direction can only be turned. */
  readonly scales: boolean;
}

let last: { readonly parts: readonly unknown[]; readonly made: SelectionBox | null } | null = null;

/**
 * The box of a selection: of several objects, of one with several places, or of one with a direction; else null. Asked often
 * with the same arguments, so the last answer is kept.
 * @param her the astronaut's box under the rules of the level
 */
export function selectionBox(file: LevelFile, her: HerBox, selected: readonly ObjectKey[]): SelectionBox | null {
  const parts = [file, her, selected];
  if (last !== null && parts.every((part, i) => part === last?.parts[i])) return last.made;
  const made = boxOf(file, her, selected);
  last = { parts, made };
  return made;
}

function boxOf(file: LevelFile, her: HerBox, selected: readonly ObjectKey[]): SelectionBox | null {
  const grabbable = grabbableIn(file);
  const keys = unlocked(file, selected).filter((key) => grabbable.has(key));
  const objects = keys.flatMap((key) => grabbable.get(key) ?? []);
  const [first] = objects;
  if (first === undefined) return null;
  const scales = objects.length > 1 || KINDS[first.kind].places.length > 1;
  if (!scales && !hasDirection(first.kind, first.object)) return null;
  const box = extentOf(file, her, keys);
  return box === null
    ? null
    : {
        keys,
        box,
        places: boxAroundAll(objects.flatMap(placesOf).map(({ x, y }) => ({ left: x, top: y, right: x, bottom: y }))),
        scales,
      };
}
