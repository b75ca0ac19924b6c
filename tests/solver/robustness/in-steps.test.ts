import fc from 'fast-check';
import { expect, it } from 'vitest';
import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { certifyInSteps, certifyWith } from '../../../solver/measure/robustness/certify.ts';
import { judgeAll } from '../../../solver/measure/robustness/index.ts';
import { clustersInSteps, shiftsUpTo } from '../../../solver/measure/robustness/shift-box.ts';
import { SLACK_LIMIT, slackOf } from '../../../solver/measure/robustness/slack.ts';
import { createTrials, judgeInSteps, type Trials } from '../../../solver/measure/robustness/trials.ts';
import { finish, type Steps } from '../../../solver/steps.ts';
import { expectDeep } from '../../depth.ts';
import { arbitraryRun } from './scenes.ts';

// Measurements in the editor can be cancelled only between two steps, so steps must be short and must not change the results.

/** Runs per step: eight, and before the first step the unchanged run. */
const MOST = 9;

/** Takes all steps. @returns what came out, and the most runs that one of them played */
function take<R>(trials: Trials, steps: Steps<R>): { result: R; most: number; steps: number } {
  let most = 0;
  for (let count = 1; ; count++) {
    const before = trials.runs;
    const step = steps.next();
    most = Math.max(most, trials.runs - before);
    if (step.done === true) return { result: step.value, most, steps: count };
  }
}

it('a certificate, slacks and many runs give the same as in one go, and each step plays few runs', () => {
  let longest = 0;
  fc.assert(
    fc.property(arbitraryRun(), fc.integer({ min: 1, max: 3000 }), ({ scene, holds: found, goal }, maxRuns) => {
      const holds = joinHolds(found);
      const trials = createTrials(scene, goal);
      const certified = take(trials, certifyInSteps(trials, holds, maxRuns, 3));
      expect(certified.result).toEqual(certifyWith(createTrials(scene, goal), holds, maxRuns, 3));
      const slack = take(trials, slackOf(trials, holds, SLACK_LIMIT));
      expect(slack.result).toEqual(finish(slackOf(createTrials(scene, goal), holds, SLACK_LIMIT)));
      const runs = shiftsUpTo(20).map((shift) =>
        joinHolds(holds.map(([a, b]): Hold => [Math.max(0, a + shift), Math.max(1, b + shift)])),
      );
      const judged = take(trials, judgeInSteps(trials, runs));
      expect(judged.result).toEqual(judgeAll(createTrials(scene, goal), runs));
      for (const { most } of [certified, slack, judged]) expect(most).toBeLessThanOrEqual(MOST);
      longest = Math.max(longest, certified.steps);
    }),
    { numRuns: 10 },
  );
  // Some took long as a whole.
  expectDeep(longest).toBeGreaterThan(50);
});

it('edges that can change places are read in pieces, too', () => {
  const holds: Hold[] = [
    [10, 12],
    [14, 16],
  ];
  const steps = clustersInSteps(holds, 3, shiftsUpTo(3), 1e6);
  let count = 0;
  while (steps.next().done !== true) count++;
  // 7 to the power of 4 combinations.
  expect(count).toBeGreaterThanOrEqual(4);
});
