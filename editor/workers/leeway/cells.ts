/** What was found at a place: whether the run completes the level; `unknown`: it takes too much work. */
export type Sample = 'completes' | 'fails' | 'unknown';

/** A rectangle of the lattice: between places, in units. */
export interface Cell {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  /** how often it was halved */
  readonly depth: number;
}

/**
 * What is known of a cell. `completes`, `fails`: its corners and its middle agree; the rest of it is a guess. `mixed`: they do not.
 * `corners`: they do not, and there is no place between its corners. `unsampled`: it has not been examined, or takes too much work.
 */
export type CellState = 'completes' | 'fails' | 'mixed' | 'corners' | 'unsampled';

/** The places of a cell that are sampled: its corners, row by row, and its middle if there is one. */
export function placesIn({ left, top, right, bottom }: Cell): readonly (readonly [i: number, j: number])[] {
  const corners = [
    [left, top],
    [right, top],
    [left, bottom],
    [right, bottom],
  ] as const;
  return isFinest({ left, top, right, bottom }) ? corners : [...corners, [(left + right) >> 1, (top + bottom) >> 1]];
}

/** Whether there is no place between its corners. */
export const isFinest = ({ left, top, right, bottom }: Omit<Cell, 'depth'>): boolean => right - left <= 1 && bottom - top <= 1;

/** The longer side of a cell, units. */
export const sideOf = ({ left, top, right, bottom }: Cell): number => Math.max(right - left, bottom - top);

/** The quarters of a cell; halves of one that is a unit wide or high. */
export function partsOf({ left, top, right, bottom, depth }: Cell): Cell[] {
  const halves = (from: number, to: number): [number, number][] => {
    const middle = (from + to) >> 1;
    return to - from > 1
      ? [
          [from, middle],
          [middle, to],
        ]
      : [[from, to]];
  };
  return halves(top, bottom).flatMap(([above, below]) =>
    halves(left, right).map(([west, east]) => ({ left: west, top: above, right: east, bottom: below, depth: depth + 1 })),
  );
}

/** @param samples at the places of the cell */
export function stateOf(cell: Cell, samples: readonly Sample[]): CellState {
  const [first, ...others] = samples;
  if (samples.includes('unknown')) return 'unsampled';
  if (first !== 'unknown' && others.every((sample) => sample === first)) return first;
  return isFinest(cell) ? 'corners' : 'mixed';
}

/** The cells of equal size that cover a rectangle, those nearest to the origin first. @param side of a cell, units */
export function coarseCells({ left, top, right, bottom }: Omit<Cell, 'depth'>, side: number): Cell[] {
  const cells: Cell[] = [];
  for (let j = Math.floor(top / side); j < Math.ceil(bottom / side); j++) {
    for (let i = Math.floor(left / side); i < Math.ceil(right / side); i++)
      cells.push({ left: i * side, top: j * side, right: (i + 1) * side, bottom: (j + 1) * side, depth: 0 });
  }
  const away = (cell: Cell) => {
    const x = (cell.left + cell.right) / 2;
    const y = (cell.top + cell.bottom) / 2;
    return x * x + y * y;
  };
  return cells.sort((a, b) => away(a) - away(b));
}
