import { type WorkBudget, WorkLimitReached } from '../engine/index.ts';

/** What some work comes to; null where it takes more than is left of a budget. */
export function withinWork<T>(budget: WorkBudget, work: () => T): T | null {
  try {
    return budget.isUsedUp ? null : work();
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}
