import { examineRuns, playRuns } from '../../../check/index.ts';
import { compile, WorkBudget } from '../../../engine/index.ts';
import { asGqCheck } from '../../proof/index.ts';
import type { Start } from '../work.ts';

/** What the runs of a level show, played to their end as far as `gq check` plays them: for levels that would keep the page too busy. */
export const check: Start<'check'> = function* ({ level, accuracy }) {
  yield null;
  const options = asGqCheck(accuracy, new WorkBudget());
  const runs = playRuns(compile(level, accuracy), options.maxTime, options.budget);
  yield null;
  return examineRuns(level, runs, options);
};
