export { checkedOf } from './check-watch.ts';
export { solverDeskOf } from './desk.ts';

export { HeatLegend } from './HeatLegend.tsx';
export { Solver } from './Solver.tsx';
export { SolverWatch } from './SolverWatch.tsx';
export { useSolverDesk } from './use-desk.ts';
export { useVerdict } from './use-verdict.ts';
