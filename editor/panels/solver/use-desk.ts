import { useEditor, useLevel } from '../../context/index.ts';
import { type SolverDesk, solverDeskOf } from './desk.ts';

/** The desk of the level around this component. */
export const useSolverDesk = (): SolverDesk => solverDeskOf(useEditor(), useLevel());
