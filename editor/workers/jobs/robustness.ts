import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import {
  BRIEF_CERTIFY_RUNS,
  type EdgeSlack,
  findSlackInSteps,
  type Goal,
  measureRobustnessInSteps,
  type Robustness,
  type Success,
  successInSteps,
} from '../../../solver/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** The robustness of a run: slack and a rough estimate of success first. */
export const robustness = job<
  Played & { readonly holds: readonly Hold[]; readonly goal: Goal },
  Robustness,
  { readonly slack: readonly EdgeSlack[]; readonly p40: Success }
>({ name: 'robustness', lane: 'long', most: 120_000 });

/** attempts for the first estimate; the final one has as many as in `gq solve` */
const FIRST_SAMPLES = 100;

/** Measures the robustness of a run: slack and a rough estimate of success first. */
export const robustnessWork: Work<typeof robustness> = {
  of: robustness,
  *steps({ level, terms, holds, goal }) {
    const scene = compile(level, terms);
    const slack = yield* findSlackInSteps(scene, holds, goal);
    const p40 = yield* successInSteps(scene, holds, goal, 40, { samples: FIRST_SAMPLES });
    yield { slack, p40 };
    return yield* measureRobustnessInSteps(scene, holds, goal, { maxRuns: BRIEF_CERTIFY_RUNS });
  },
};
