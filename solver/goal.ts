/** What a run has to achieve besides reaching the black hole: how many different minerals it collects. */
export interface Goal {
  /** `any`: none needed, `all`: every one in the level, a number: at least so many */
  readonly minerals: 'any' | 'all' | number;
}

/** How many different minerals a goal asks for in a level that has `count` of them. */
export function mineralsNeeded(goal: Goal, count: number): number {
  if (goal.minerals === 'any') return 0;
  return goal.minerals === 'all' ? count : goal.minerals;
}
