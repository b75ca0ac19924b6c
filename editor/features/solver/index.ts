export { checkedOf } from './check-watch.ts';
export { HeatLegend } from './HeatLegend.tsx';
export { Solver } from './Solver.tsx';
export { SolverWatch } from './SolverWatch.tsx';
export { solverSessionOf } from './solver-session.ts';
export { useSolverSession } from './use-solver-session.ts';
export { useVerdict } from './use-verdict.ts';
