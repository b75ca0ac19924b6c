import type { Disc, ListedKind, ObjectList, Place, Rules } from '../../../../schema/basics/index.ts';

/** An object as in a level file, with numbers as its only fields. */
export type PlacedObject = Disc & Readonly<Record<string, number>>;

/** What a kind needs to know to place an object. */
export interface Ground {
  /** A random whole number in [least, most]. */
  between(least: number, most: number): number;
  /** A random place near an asteroid, where she may pass. */
  inPlay(): Place;
  /** Whether a disc lies within the level and keeps its distance from the start. */
  isClear(disc: Disc): boolean;
  /** Whether it also keeps its distance, `gap` px, from all objects that are drawn solid. */
  isFree(disc: Disc, gap?: number): boolean;
  /** Where she starts. */
  readonly start: Place;
  readonly rules: Rules;
  /** The objects of the same kind placed so far. */
  readonly others: readonly PlacedObject[];
}

/** A kind of object that a level may get near its asteroids. */
export interface PlacedKind {
  readonly kind: ListedKind;
  /** The name of its list in a level file, by which it is requested. */
  readonly list: ObjectList;
  /** Whether levels may have it unless told otherwise; others get it only on request, and then more often. */
  readonly isUsual: boolean;
  /** Whether other objects keep their distance from it. Objects that are not solid may lie over others. */
  readonly isSolid: boolean;
  /** Its turn when idle objects are removed; novae have turn 2, asteroids 3. */
  readonly turn: number;
  /** Tries to make one object; null when it does not fit. */
  make(ground: Ground): PlacedObject | null;
}

/** px between two objects of one kind, at least. */
export const APART = 12;

/** Distance between two places, px. */
export function distance(a: Place, b: Place): number {
  const [dx, dy] = [a.x - b.x, a.y - b.y];
  return Math.sqrt(dx * dx + dy * dy);
}
