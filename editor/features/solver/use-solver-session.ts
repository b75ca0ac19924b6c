import { useEditor, useLevel } from '../../core/context/index.ts';
import { type SolverSession, solverSessionOf } from './solver-session.ts';

/** The solver session of the level around this component. */
export const useSolverSession = (): SolverSession => solverSessionOf(useEditor(), useLevel());
