import { compile } from '../../../engine/index.ts';
import { findSlack, measureRobustness, successProbability } from '../../../solver/index.ts';
import type { Start } from '../work.ts';

/** Executions for the first word; the last one has as many as `gq solve` tries. */
const FIRST_SAMPLES = 100;

/** Runs for the certificate: while one edits, a few seconds are long. */
const CERTIFY_RUNS = 20_000;

/** Measures what a run forgives: slack and a rough probability first. */
export const robustness: Start<'robustness'> = function* ({ level, accuracy, holds, goal }) {
  const scene = compile(level, accuracy);
  const slack = findSlack(scene, holds, goal);
  yield { slack, p40: successProbability(scene, holds, goal, 40, { samples: FIRST_SAMPLES }) };
  return measureRobustness(scene, holds, goal, { maxRuns: CERTIFY_RUNS });
};
