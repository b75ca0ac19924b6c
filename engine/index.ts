export * from './accuracy.ts';
export type { Clearance } from './clearance.ts';
export * from './constants.ts';
export { boxCircleGap, boxOverlapsCircle, circlesOverlap } from './contact/index.ts';
export { EFFECTS, type Effect, type EffectChoice } from './effects/index.ts';
export { type Circles, compile, type Scene } from './scene.ts';
export { joinHolds, playScript } from './script.ts';
export { createSimulation, type Run, type SimulateOptions, type State, simulate } from './simulate.ts';
export * from './simulation.ts';
export type { Trajectory } from './trajectory.ts';
export {
  findWarnings,
  MAX_WARNINGS_PER_CODE,
  WARNING_CODES,
  type Warning,
  type WarningExplanation,
} from './warnings/index.ts';
export { DEFAULT_MAX_WORK, unlimited, WorkBudget, WorkLimitReached } from './work-budget.ts';
