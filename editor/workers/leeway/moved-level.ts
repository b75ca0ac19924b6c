import { KINDS, type Level, LIMITS, type ObjectKind } from '../../../schema/index.ts';

/** An object that is moved. */
export interface MovedObject {
  readonly kind: ObjectKind;
  /** Index in its list; 0 for the astronaut and the black hole. */
  readonly index: number;
}

type Numbers = Record<string, number>;

/**
 * The level with some objects elsewhere, all moved alike.
 * @param only index of the only place of each object that moves; null: all of them
 * @returns null if one of them would stand where no object of a level can
 */
export function movedLevel(
  level: Level,
  objects: readonly MovedObject[],
  { dx, dy }: { readonly dx: number; readonly dy: number },
  only: number | null,
): Level | null {
  const moved = { ...level } as unknown as Record<string, Numbers | Numbers[]>;
  const copied = new Set<string>();
  for (const { kind, index } of objects) {
    const { list, places } = KINDS[kind];
    if (list !== null && !copied.has(list)) {
      moved[list] = [...(moved[list] as Numbers[])];
      copied.add(list);
    }
    const object = { ...(list === null ? (moved[kind] as Numbers) : (moved[list] as Numbers[])[index]) };
    for (const [i, [x, y]] of places.entries()) {
      if (only !== null && i !== only) continue;
      object[x] += dx;
      object[y] += dy;
      if (Math.max(Math.abs(object[x]), Math.abs(object[y])) > LIMITS.coordinate) return null;
    }
    if (list === null) moved[kind] = object;
    else (moved[list] as Numbers[])[index] = object;
  }
  return moved as unknown as Level;
}
