import type { ExamineOptions } from '../../check/index.ts';
import { DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, type Scene, type WorkBudget } from '../../engine/index.ts';

/** The options of `gq check` by default. @param budget what is left for the runs of the level */
export const asGqCheck = (scene: Scene, budget: WorkBudget): ExamineOptions => ({
  scene,
  maxTime: DEFAULT_MAX_TIME,
  maxWork: DEFAULT_MAX_WORK,
  budget,
});
