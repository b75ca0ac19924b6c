import { measureWorkPrecision } from '../../../engine/work-precision/index.ts';
import type { Start } from '../work.ts';

/** ms for the timing */
const BUDGET = 1500;

/** Measures errors and costs of all settings for one level and run; of the terms, only the time limit matters to it. */
export const accuracy: Start<'accuracy'> = function* ({ level, terms: { maxTime }, holds }, now) {
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
};
