import { type WorkBudget, WorkLimitReached } from '../engine/index.ts';

/**
 * Does some work within a budget.
 * @param budget the budget that `work` spends
 * @param work the work; it may throw `WorkLimitReached`
 * @returns the result of `work`, or null when the budget is or becomes spent
 */
export function withinWork<T>(budget: WorkBudget, work: () => T): T | null {
  try {
    return budget.isUsedUp ? null : work();
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}
