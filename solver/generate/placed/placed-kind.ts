import type { Disc, ListedKind, ObjectList, Place } from '../../../schema/index.ts';

/** An object as a file has it, all of whose fields are numbers. */
export type PlacedObject = Disc & Readonly<Record<string, number>>;

/** Where an object may be put. */
export interface Ground {
  /** A whole number in [least, most]. */
  between(least: number, most: number): number;
  /** A place where she comes by. */
  inPlay(): Place;
  /** Whether a disc lies within the level and keeps away from the start. */
  isClear(disc: Disc): boolean;
  /** Whether it also keeps the gap to all that is drawn solid. */
  isFree(disc: Disc): boolean;
  /** Those of the same kind that are there. */
  readonly others: readonly PlacedObject[];
}

/** A kind of object that a level gets only where it is asked for. */
export interface PlacedKind {
  readonly kind: ListedKind;
  /** Its list in a file, by which it is asked for. */
  readonly list: ObjectList;
  /** Whether others keep off it; what is not lies over them. */
  readonly isSolid: boolean;
  /** A try to make one; null where it does not fit. */
  make(ground: Ground): PlacedObject | null;
}

/** px between things of one kind, at least. */
export const APART = 12;

export function distance(a: Place, b: Place): number {
  const [dx, dy] = [a.x - b.x, a.y - b.y];
  return Math.sqrt(dx * dx + dy * dy);
}
