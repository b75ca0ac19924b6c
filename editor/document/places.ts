import { KINDS, type ObjectKind, placesIn } from '../../schema/index.ts';
import type { FoundObject, PlacedObject } from './objects.ts';

/** A place of the level, px. */
interface Place {
  readonly x: number;
  readonly y: number;
}

type Numbers = Record<string, number>;

/** Where an object is: for most kinds one place, for some several, the first of which is its own `x` and `y`. */
export const placesOf = ({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): readonly Place[] => placesIn(kind, object);

/**
 * A copy of an object with its places changed.
 * @param change where a place comes to, from where it is
 * @param only index of the one place that is changed; all of them when left out
 */
export function withPlaces<T extends PlacedObject>(
  kind: ObjectKind,
  object: T,
  change: (place: Place, index: number) => Place,
  only?: number,
): T {
  const changed = { ...object };
  const numbers = changed as unknown as Numbers;
  for (const [i, [x, y]] of KINDS[kind].places.entries()) {
    if (only !== undefined && i !== only) continue;
    const place = change({ x: numbers[x], y: numbers[y] }, i);
    numbers[x] = place.x;
    numbers[y] = place.y;
  }
  return changed;
}

/** A copy of an object, all of it moved by so many px. @param only index of the one place that moves; all of them when left out */
export const shifted = <T extends PlacedObject>(kind: ObjectKind, object: T, dx: number, dy: number, only?: number): T =>
  withPlaces(kind, object, ({ x, y }) => ({ x: x + dx, y: y + dy }), only);
