import type { Outcome } from '../../../engine/index.ts';
import { measureWorkPrecision } from '../../../engine/work-precision/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** One setting in a work-precision diagram. */
export interface Setting {
  readonly name: string;
  /** px */
  readonly error: number;
  /** microseconds per simulated second */
  readonly cost: number;
  readonly outcome: Outcome;
  readonly sameVerdict: boolean;
}

/** Errors and costs of all settings for this level and run. */
export const accuracy = job<Played & { readonly holds: readonly Hold[] }, { readonly settings: readonly Setting[] }>({
  name: 'accuracy',
  lane: 'long',
  most: 60_000,
});

/** ms for the timing */
const BUDGET = 1500;

/** Measures errors and costs of all settings for one level and run; of the terms, only the time limit matters to it. */
export const accuracyWork: Work<typeof accuracy> = {
  of: accuracy,
  *steps({ level, terms: { maxTime }, holds }, now) {
    yield null;
    const measured = measureWorkPrecision(level, holds, { maxTime, now, budget: BUDGET });
    const settings = measured.methods.map(({ accuracy: { name }, error, cost, outcome, sameVerdict }) => ({
      name,
      error,
      cost: cost.minimum,
      outcome,
      sameVerdict,
    }));
    return { settings };
  },
};
