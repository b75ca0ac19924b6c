import type { Accuracy } from '../accuracy.ts';
import { ALL_EFFECTS, type EffectSet } from '../effects/index.ts';
import { integratorOf } from '../integrators/index.ts';
import type { Integrator } from '../motion/index.ts';

/** What a simulation in continuous time is made of. */
export interface Method {
  /** The effects that scenes may call for. */
  readonly effects: EffectSet;
  /** The integrator of an accuracy. */
  readonly integratorOf: (accuracy: Accuracy) => Integrator;
}

/** The method for every scene and accuracy. */
export const WHOLE_METHOD: Method = { effects: ALL_EFFECTS, integratorOf };
