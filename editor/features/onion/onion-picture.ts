import { type Disc, KINDS, type LevelFile } from '../../../schema/index.ts';
import type { Box } from '../../canvas/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf } from '../../core/document/index.ts';
import type { FormerRun } from './former.ts';

/** A line between two points, px of the level. */
interface Link {
  readonly from: { readonly x: number; readonly y: number };
  readonly to: { readonly x: number; readonly y: number };
}

/** At most so many outlines are shown: more would hide the level, and take longer to draw than a frame lasts. */
const MOST_OUTLINES = 100;

/** What the canvas shows of a level as it was before a change. */
export interface OnionPicture {
  /** The way of the run: x, y in px, two entries per tick. */
  readonly points: Float32Array;
  /** Outlines of the objects that differ, where they were; none if they are too many to be told apart. */
  readonly discs: readonly Disc[];
  /** The box around all of them, where they were, if they are too many; else null. */
  readonly extent: Box | null;
  /** The place of the astronaut's start if that differs, and her box. */
  readonly start: { readonly x: number; readonly y: number } | null;
  readonly her: FormerRun['her'];
  /** From where the objects were to where they are. */
  readonly links: readonly Link[];
}

/** @param file the level as it is now */
export function onionPictureOf({ file: before, her, points }: FormerRun, file: LevelFile): OnionPicture {
  const discs: Disc[] = [];
  const links: Link[] = [];
  let start: OnionPicture['start'] = null;
  for (const { was, is } of changedObjects(before, file)) {
    const radius = radiusOf(was);
    const now = is === null ? [] : placesOf(is);
    for (const [i, from] of placesOf(was).entries()) {
      if (radius === null) start = { x: from.x, y: from.y };
      else discs.push({ x: from.x, y: from.y, radius });
      const to = now[i];
      if (to !== undefined && (to.x !== from.x || to.y !== from.y)) links.push({ from, to });
    }
  }
  if (discs.length <= MOST_OUTLINES) return { points, discs, extent: null, start, her, links };
  const isHers = ({ from }: Link) => start !== null && from.x === start.x && from.y === start.y;
  return { points, discs: [], extent: extentOf(discs), start, her, links: links.filter(isHers) };
}

const extentOf = (discs: readonly Disc[]): Box =>
  discs.reduce(
    ({ left, top, right, bottom }, { x, y, radius }) => ({
      left: Math.min(left, x - radius),
      top: Math.min(top, y - radius),
      right: Math.max(right, x + radius),
      bottom: Math.max(bottom, y + radius),
    }),
    { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity },
  );

// the objects that a change has touched

/** An object that a change moved, resized or deleted. */
interface ChangedObject {
  readonly key: ObjectKey;
  readonly was: FoundObject;
  /** null: it was deleted */
  readonly is: FoundObject | null;
}

function looksOther(was: FoundObject, is: FoundObject): boolean {
  if (was.kind !== is.kind || (KINDS[was.kind].radius !== null && was.object.radius !== is.object.radius)) return true;
  const then = placesOf(was);
  return placesOf(is).some(({ x, y }, i) => x !== then[i]?.x || y !== then[i]?.y);
}

/** The objects whose outlines differ between two states of a level. Objects that the files share are compared by reference. */
export function changedObjects(before: LevelFile, after: LevelFile): ChangedObject[] {
  const now = objectsOf(after);
  const changed: ChangedObject[] = [];
  for (const [key, was] of objectsOf(before)) {
    const is = now.get(key) ?? null;
    if (is === null || (is.object !== was.object && looksOther(was, is))) changed.push({ key, was, is });
  }
  return changed;
}
