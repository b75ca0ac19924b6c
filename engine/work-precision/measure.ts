import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { TICK_RATE } from '../constants.ts';
import { compareWith, type Deviation } from './compare.ts';
import { type Cost, measureCosts, playerOf } from './cost.ts';
import { METHODS } from './methods.ts';
import { type Reference, referenceOf } from './reference.ts';

/** One point of a work-precision diagram. */
export interface Measured extends Deviation {
  readonly accuracy: Accuracy;
  readonly cost: Cost;
}

export interface WorkPrecision {
  readonly reference: Reference;
  readonly methods: readonly Measured[];
}

export interface MeasureOptions {
  /** Simulated time after which a run is a timeout, s. */
  readonly maxTime: number;
  /** A clock, ms; the engine has none. */
  readonly now: () => number;
  /** Approximate time for timing, ms; comparing takes additional time. */
  readonly budget: number;
  /** The settings to measure; {@link METHODS} when left out. */
  readonly methods?: readonly Accuracy[];
}

const SAMPLE = 1;

/** Measures what each setting costs in time and in error, for one list of holds on a level. */
export function measureWorkPrecision(level: Level, holds: readonly Hold[], options: MeasureOptions): WorkPrecision {
  const { now, budget, methods = METHODS } = options;
  const maxTicks = Math.round(options.maxTime * TICK_RATE);
  const reference = referenceOf(level, holds, maxTicks);
  const deviations = methods.map((accuracy) => compareWith(reference, level, holds, accuracy, maxTicks));
  const players = methods.map((accuracy) => playerOf([{ level, holds }], accuracy, maxTicks));
  const costs = measureCosts(players, now, { budget, sample: SAMPLE });
  return { reference, methods: methods.map((accuracy, i) => ({ accuracy, ...deviations[i], cost: costs[i] })) };
}

/** Below this error a setting is as good as exact for a level designer, px: a hundredth of what a screen can show. */
export const GOOD_ENOUGH = 0.01;

/** The cheapest setting with the reference's outcome and an error below {@link GOOD_ENOUGH}; null if there is none. */
export function cheapestGoodEnough(methods: readonly Measured[]): Measured | null {
  let best: Measured | null = null;
  for (const method of methods) {
    if (!method.sameVerdict || method.error >= GOOD_ENOUGH) continue;
    if (best === null || method.cost.minimum < best.cost.minimum) best = method;
  }
  return best;
}
