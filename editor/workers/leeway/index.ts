export { CELL_NUMBERS, cornerCompletes, stateOfCode } from './cell-codes.ts';
export type { CellState, Sample } from './cells.ts';
export { type Lattice, latticeFor, shiftTo } from './lattice.ts';
export { type MovedObject, movedLevel } from './moved-level.ts';
export { MOST_REACH, type Reach, Survey } from './survey.ts';
