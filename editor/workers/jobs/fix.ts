import { proveGoalImpossible } from '../../../check/index.ts';
import { ACCURACIES, DEFAULT_MAX_TICKS, DEFAULT_MAX_WORK, WorkBudget } from '../../../engine/index.ts';
import { createRepair } from '../../../solver/index.ts';
import type { Fixing } from '../protocol.ts';
import { createPacer, type Start } from '../work.ts';

/** ms between two reports */
const TELL = 250;

/** Seeks changes that make a level completable, as `gq fix` does. */
export const fix: Start<'fix'> = function* ({ level, accuracy, seed, budget }, now) {
  const start = now();
  const setting = ACCURACIES[accuracy];
  const proofs = new WorkBudget(DEFAULT_MAX_WORK / 2);
  const proof = proveGoalImpossible(level, setting, { minerals: 'any' }, DEFAULT_MAX_TICKS, proofs);
  yield null;
  const repair = createRepair(level, setting, { seed, proof });
  const found = (): Fixing => {
    const { effort, completing, finished, proposals } = repair;
    return { proposals: [...proposals], effort: { ...effort }, isImpossible: proof !== null, completing, finished };
  };
  const pace = createPacer(now);
  let told = now();
  while (!repair.finished && now() - start < budget) {
    pace((ticks) => repair.advance(ticks));
    const isDue = now() - told >= TELL;
    if (isDue) told = now();
    yield isDue ? found() : null;
  }
  return found();
};
