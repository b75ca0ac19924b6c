import { proveGoalImpossible } from '../../../check/index.ts';
import { compile } from '../../../engine/index.ts';
import { createRepair, type Effort, type Proposal } from '../../../solver/index.ts';
import { createPacer, createReporting, job, type Played, type Work } from '../job.ts';

/** What was found to make a level completable. */
export interface Fixing {
  /** The smallest first. */
  readonly proposals: readonly Proposal[];
  readonly effort: Effort;
  /** Whether the level is proved impossible as it is. */
  readonly isImpossible: boolean;
  /** Index of a run that completes the level as it is; null if none of its own does. */
  readonly completing: number | null;
  /** Whether all was tried; false: the time was over. */
  readonly finished: boolean;
}

/** Changes that make the level completable, within a budget, ms. */
export const fix = job<Played & { readonly seed: number; readonly budget: number }, Fixing, Fixing>({
  name: 'fix',
  lane: 'long',
  most: null,
});

/** ms between two reports */
const REPORT = 250;

/** Seeks changes that make a level completable, as `gq fix` does. */
export const fixWork: Work<typeof fix> = {
  of: fix,
  *steps({ level, terms, seed, budget }, now) {
    const start = now();
    const proof = proveGoalImpossible(compile(level, terms), { minerals: 'any' });
    yield null;
    const repair = createRepair(level, terms, { seed, proof });
    const found = (): Fixing => {
      const { effort, completing, finished, proposals } = repair;
      return { proposals: [...proposals], effort: { ...effort }, isImpossible: proof !== null, completing, finished };
    };
    const pace = createPacer(now);
    const isReportDue = createReporting(REPORT, start, now);
    while (!repair.finished && now() - start < budget) {
      pace((ticks) => repair.advance(ticks));
      yield isReportDue() ? found() : null;
    }
    return found();
  },
};
