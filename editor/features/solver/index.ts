export { solverSessionOf } from './solver-session.ts';
