import type { LevelFile } from '../../../schema/index.ts';
import { type FoundObject, nameOf, type ObjectKey, objectsOf, placesOf, radiusOf } from '../../core/document/index.ts';
import type { Hit } from '../hit-test.ts';
import type { Point } from '../view.ts';

const number = (value: number): string => String(Number(value.toFixed(2)));

/** `x 448, y 304` */
export const placeInWords = ({ x, y }: Point): string => `x ${number(x)}, y ${number(y)}`;

/** `asteroid 2`, and whether it is selected or its rim can be dragged. */
export function thingInWords(file: LevelFile, hit: Hit, selected: readonly ObjectKey[]): string {
  const found = objectsOf(file).get(hit.key);
  if (found === undefined) return 'empty';
  const name = nameOf(found).toLowerCase();
  return `${hit.part === 'rim' ? `rim of ${name}` : name}${selected.includes(hit.key) ? ', selected' : ''}`;
}

/** What the crosshair passes by: `asteroid 2, locked`, or `empty`. */
export const passedByInWords = (locked: FoundObject | null): string =>
  locked === null ? 'empty' : `${nameOf(locked).toLowerCase()}, locked`;

const withRadius = (found: FoundObject): string => {
  const radius = radiusOf(found);
  return radius === null ? '' : `, radius ${number(radius)}`;
};

/**
 * What was added, moved or resized between two states of a level: `Asteroid 4 added at x 448, y 304, radius 16`; null: nothing.
 */
export function changeInWords(before: LevelFile, after: LevelFile): string | null {
  const old = objectsOf(before);
  const all = [...objectsOf(after).values()];
  const [added, ...others] = all.filter(({ key }) => !old.has(key));
  if (added !== undefined) {
    return others.length > 0
      ? `${others.length + 1} objects added`
      : `${nameOf(added)} added at ${placeInWords(added.object)}${withRadius(added)}`;
  }
  const changed = all.filter(({ key, object }) => old.get(key)?.object !== object);
  const [first] = changed;
  const was = first === undefined ? undefined : old.get(first.key);
  if (was === undefined) return null;
  const then = placesOf(was);
  const moved = placesOf(first).find(({ x, y }, i) => x !== then[i].x || y !== then[i].y);
  if (changed.length > 1) return `${changed.length} objects ${moved === undefined ? 'resized' : 'moved'}`;
  return moved === undefined ? `${nameOf(first)}${withRadius(first)}` : `${nameOf(first)} moved to ${placeInWords(moved)}`;
}

/** How Enter or a marquee changed the selection. */
export function selectionInWords(file: LevelFile, before: readonly ObjectKey[], after: readonly ObjectKey[]): string {
  const named = (key: ObjectKey | undefined) => {
    const found = key === undefined ? undefined : objectsOf(file).get(key);
    return found === undefined ? '' : nameOf(found);
  };
  const gone = before.filter((key) => !after.includes(key));
  if (after.length === 0) return 'Nothing is selected';
  if (gone.length === 1 && after.length === before.length - 1)
    return `${named(gone[0])} is no longer selected, ${after.length} still selected`;
  if (after.length === 1) return `${named(after[0])} is selected`;
  const added = after.filter((key) => !before.includes(key));
  return added.length === 1 ? `${named(added[0])} is selected, ${after.length} in all` : `${after.length} objects are selected`;
}
