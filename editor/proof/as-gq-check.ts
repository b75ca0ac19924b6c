import type { ExamineOptions } from '../../check/index.ts';
import { ACCURACIES, type AccuracyName, DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, type WorkBudget } from '../../engine/index.ts';

/** What `gq check` allows where nothing else is said. @param budget of what is left for the level's runs */
export const asGqCheck = (accuracy: AccuracyName, budget: WorkBudget): ExamineOptions => ({
  accuracy: ACCURACIES[accuracy],
  maxTime: DEFAULT_MAX_TIME,
  maxWork: DEFAULT_MAX_WORK,
  budget,
});
