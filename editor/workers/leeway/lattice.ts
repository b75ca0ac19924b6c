/** A place, px of the level. */
interface Place {
  readonly x: number;
  readonly y: number;
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
