import { examineRuns, playRuns, type RunFindings } from '../../../check/index.ts';
import { compile, WorkBudget } from '../../../engine/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** The findings of all runs of a level. */
export const check = job<Played, RunFindings>({ name: 'check', lane: 'quick', most: 20_000 });

/** The findings of a level's runs, simulated as far as `gq check` does: for levels that would block the page. */
export const checkWork: Work<typeof check> = {
  of: check,
  *steps({ level, terms }) {
    yield null;
    const scene = compile(level, terms);
    const budget = new WorkBudget(terms.maxWork);
    const runs = playRuns(scene, budget);
    yield null;
    return examineRuns(level, runs, { scene, budget });
  },
};
