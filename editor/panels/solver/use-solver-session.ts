import { useEditor, useLevel } from '../../context/index.ts';
import { type SolverSession, solverSessionOf } from './solver-session.ts';

/** What is looked for and measured in the level around this component. */
export const useSolverSession = (): SolverSession => solverSessionOf(useEditor(), useLevel());
