export { type Lattice, latticeFor, type MovedObject, movedLevel, shiftTo } from './moved-level.ts';
export {
  CELL_NUMBERS,
  type CellState,
  cornerCompletes,
  MOST_REACH,
  type Reach,
  type Sample,
  Survey,
  stateOfCode,
} from './survey.ts';
