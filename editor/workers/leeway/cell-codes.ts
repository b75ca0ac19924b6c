import { type Cell, type CellState, placesIn, type Sample } from './cells.ts';

/** Numbers per cell: left, top, right, bottom in units, and its state. */
export const CELL_NUMBERS = 5;

const STATES: readonly CellState[] = ['completes', 'fails', 'mixed', 'unsampled', 'corners'];
const CORNERS = STATES.indexOf('corners');

/** The state of a cell as a number; of `corners` also which of them complete. */
export function codeOf(cell: Cell, state: CellState, sampleAt: (i: number, j: number) => Sample | null): number {
  if (state !== 'corners') return STATES.indexOf(state);
  const bits = placesIn(cell).reduce((sum, [i, j], k) => sum + (sampleAt(i, j) === 'completes' ? 1 << k : 0), 0);
  return CORNERS + STATES.length * bits;
}

export const stateOfCode = (code: number): CellState => STATES[code % STATES.length];

/** Whether a corner completes: 0 left above, 1 right above, 2 left below, 3 right below. */
export const cornerCompletes = (code: number, corner: number): boolean =>
  ((Math.floor(code / STATES.length) >> corner) & 1) === 1;
