import type { Box as HerBox } from '../../../engine/index.ts';
import { KINDS, type LevelFile } from '../../../schema/index.ts';
import { grabbableIn, hasDirection, type ObjectKey, placesOf, unlocked } from '../../core/document/index.ts';
import { extentOf } from '../extent.ts';
import type { Box, Point } from '../view.ts';

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

export const centreOf = ({ left, top, right, bottom }: Box): Point => ({ x: (left + right) / 2, y: (top + bottom) / 2 });

function around(points: readonly Point[]): Box {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  const least = (values: readonly number[]) => values.reduce((a, b) => Math.min(a, b));
  const most = (values: readonly number[]) => values.reduce((a, b) => Math.max(a, b));
  return { left: least(xs), top: least(ys), right: most(xs), bottom: most(ys) };
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
  return box === null ? null : { keys, box, places: around(objects.flatMap(placesOf)), scales };
}
