/** What a run has to achieve besides reaching the black hole. */
export interface Goal {
  /**
   * How many different minerals the run must collect: `any` requires none, `all` requires every one in the level, a whole
   * number requires at least that many.
   */
  readonly minerals: 'any' | 'all' | number;
}

/**
 * Converts a goal into a number of minerals.
 * @param goal what a run has to achieve
 * @param count the number of minerals in the level
 * @returns how many different minerals a run must collect; this may exceed `count`
 */
export function mineralsNeeded(goal: Goal, count: number): number {
  if (goal.minerals === 'any') return 0;
  return goal.minerals === 'all' ? count : goal.minerals;
}
