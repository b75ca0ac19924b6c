import { proveGoalImpossible } from '../../../check/index.ts';
import { compile } from '../../../engine/index.ts';
import { createRepair } from '../../../solver/index.ts';
import type { Fixing } from '../protocol.ts';
import { createPacer, type Start } from '../work.ts';

/** ms between two reports */
const TELL = 250;

/** Seeks changes that make a level completable, as `gq fix` does. */
export const fix: Start<'fix'> = function* ({ level, terms, seed, budget }, now) {
  const start = now();
  const proof = proveGoalImpossible(compile(level, terms), { minerals: 'any' });
  yield null;
  const repair = createRepair(level, terms, { seed, proof });
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
