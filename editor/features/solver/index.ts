export { checkedOf } from './check-watch.ts';
export { solverSessionOf } from './solver-session.ts';
export { useSolverSession } from './use-solver-session.ts';
export { useVerdict } from './use-verdict.ts';
