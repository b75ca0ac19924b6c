import { compile } from '../../../engine/index.ts';
import { BRIEF_CERTIFY_RUNS, findSlackInSteps, measureRobustnessInSteps, successInSteps } from '../../../solver/index.ts';
import type { Start } from '../work.ts';

/** attempts for the first estimate; the final one has as many as in `gq solve` */
const FIRST_SAMPLES = 100;

/** Measures the robustness of a run: slack and a rough estimate of success first. */
export const robustness: Start<'robustness'> = function* ({ level, terms, holds, goal }) {
  const scene = compile(level, terms);
  const slack = yield* findSlackInSteps(scene, holds, goal);
  const p40 = yield* successInSteps(scene, holds, goal, 40, { samples: FIRST_SAMPLES });
  yield { slack, p40 };
  return yield* measureRobustnessInSteps(scene, holds, goal, { maxRuns: BRIEF_CERTIFY_RUNS });
};
