import type { Accuracy } from '../accuracy.ts';
import type { EffectSet } from '../effects/index.ts';
import type { Integrator } from '../motion/index.ts';

/** What a simulation in continuous time is made of. */
export interface Method {
  /** The effects that scenes may call for. */
  readonly effects: EffectSet;
  /** The integrator of an accuracy. */
  readonly integratorOf: (accuracy: Accuracy) => Integrator;
}
