import { examineRuns, playRuns } from '../../../check/index.ts';
import { compile, WorkBudget } from '../../../engine/index.ts';
import type { Start } from '../work.ts';

/** The findings of a level's runs, simulated as far as `gq check` does: for levels that would block the page. */
export const check: Start<'check'> = function* ({ level, terms }) {
  yield null;
  const scene = compile(level, terms);
  const budget = new WorkBudget(terms.maxWork);
  const runs = playRuns(scene, budget);
  yield null;
  return examineRuns(level, runs, { scene, budget });
};
