import { examineRuns, playRuns } from '../../../check/index.ts';
import { compile, WorkBudget } from '../../../engine/index.ts';
import { asGqCheck } from '../../proof/index.ts';
import type { Start } from '../work.ts';

/** The findings of a level's runs, simulated as far as `gq check` does: for levels that would block the page. */
export const check: Start<'check'> = function* ({ level, accuracy }) {
  yield null;
  const scene = compile(level, accuracy);
  const options = asGqCheck(scene, new WorkBudget());
  const runs = playRuns(scene, options.maxTime, options.budget);
  yield null;
  return examineRuns(level, runs, options);
};
