import { KINDS, type Level, LIMITS, type ObjectKind, type Place } from '../../../schema/index.ts';

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

/** The places that are sampled: at whole numbers of a unit from an origin. */
export interface Lattice extends Place {
  /** px between neighbouring places */
  readonly unit: number;
  /** Units between places on which objects snap: those of the grid, or whole px. */
  readonly base: number;
}

/**
 * The lattice that has every place of the grid, or every place that is whole px away.
 * @param lead place of the object that snaps to the grid, px
 * @param grid px between grid lines; null: objects do not snap to it
 */
export function latticeFor(lead: Place, grid: number | null): Lattice {
  if (grid === null) return { ...lead, unit: 1, base: 1 };
  const onGrid = (value: number) => Math.round(value / grid) * grid;
  const origin = { x: onGrid(lead.x), y: onGrid(lead.y) };
  // between the lines of a grid of fractions of px there are no whole px
  return Number.isInteger(grid) ? { ...origin, unit: 1, base: grid } : { ...origin, unit: grid, base: 1 };
}

/**
 * How far the objects are moved to put the lead on a place of the lattice, px: by the same sum as when it is dragged there, to the
 * last bit.
 */
export const shiftTo = (
  { x, y, unit }: Lattice,
  lead: Place,
  i: number,
  j: number,
): { readonly dx: number; readonly dy: number } => ({
  dx: x === lead.x ? i * unit : x + i * unit - lead.x,
  dy: y === lead.y ? j * unit : y + j * unit - lead.y,
});
