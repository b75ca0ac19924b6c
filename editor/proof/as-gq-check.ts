import type { ExamineOptions } from '../../check/index.ts';
import { ACCURACIES, type AccuracyName, DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, type WorkBudget } from '../../engine/index.ts';

/** The options of `gq check` by default. @param budget what is left for the runs of the level */
export const asGqCheck = (accuracy: AccuracyName, budget: WorkBudget): ExamineOptions => ({
  accuracy: ACCURACIES[accuracy],
  maxTime: DEFAULT_MAX_TIME,
  maxWork: DEFAULT_MAX_WORK,
  budget,
});
