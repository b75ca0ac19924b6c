export {
  ACCURACIES,
  ACCURACY_LIMITS,
  type Accuracy,
  type AccuracyName,
  accuracyOf,
  type ContactTest,
  DEFAULT_ACCURACY,
  type Integrator,
  isAccuracyName,
  type Setting,
} from './accuracy.ts';
export type { Clearance } from './clearance.ts';
export { atAccuracy, compile } from './compile.ts';
export * from './constants.ts';
export { type Box, boxCircleGap, boxOf, boxOverlapsCircle, circlesOverlap, DEFAULT_BOX } from './contact.ts';
export { type EffectWork, workByEffect } from './continuous/index.ts';
export { EFFECTS, type Effect, effectEventInWords } from './effects/index.ts';
export { Hash } from './hash.ts';
export type { Circles, IndexedCircles, SpatialIndex } from './indexed-circles.ts';
export type { Aliens, ChosenEffect, EffectChoice, Scene } from './scene.ts';
export { joinHolds, playScript } from './script.ts';
export { createSimulation, type Run, type SimulateOptions, type State, simulate } from './simulate.ts';
export {
  type BodyKind,
  type Ending,
  isJump,
  type Mode,
  type Outcome,
  type RunEvent,
  type Simulation,
  STATE_SIZE,
  type Touched,
  type Trajectory,
  type Work,
} from './simulation.ts';
export { DEFAULT_TERMS, maxTicksOf, type Terms, termsOf, unusualTerms } from './terms.ts';
export * from './warnings/index.ts';
export { DEFAULT_MAX_WORK, unlimited, WorkBudget, WorkLimitReached } from './work-budget.ts';
