import { KINDS, type ObjectKind, placesIn } from '../../../schema/index.ts';
import type { FoundObject, PlacedObject } from './objects.ts';

/** A place in the level, px. */
interface Place {
  readonly x: number;
  readonly y: number;
}

type Numbers = Record<string, number>;

/** The places of an object: one for most kinds; for kinds with several, the first is its `x` and `y`. */
export const placesOf = ({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): readonly Place[] => placesIn(kind, object);

/**
 * A copy of an object with changed places.
 * @param change returns the new place
 * @param only index of the only place to change; all of them if absent
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

/** A copy of an object, moved by `dx`, `dy` px. @param only index of the only place to move; all of them if absent */
export const shifted = <T extends PlacedObject>(kind: ObjectKind, object: T, dx: number, dy: number, only?: number): T =>
  withPlaces(kind, object, ({ x, y }) => ({ x: x + dx, y: y + dy }), only);
