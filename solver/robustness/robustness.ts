import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { finish, type Steps } from '../steps.ts';
import { certifyInSteps } from './certify.ts';
import { type EdgeSlack, SLACK_LIMIT, slackOf } from './slack.ts';
import { countInSteps, DEFAULT_SAMPLES, type SampleOptions, type Success, toSuccess } from './success-probability.ts';
import { tickNoise } from './tick-noise.ts';
import { createTrials } from './trials.ts';

/** How much a run forgives. */
export interface Robustness {
  /** Success under timing noise of 30, 40, 60 and 80 ms an edge. */
  readonly p30: Success;
  readonly p40: Success;
  readonly p60: Success;
  readonly p80: Success;
  /** All combinations of shifts by up to so many ticks succeed. */
  readonly certifiedTicks: number;
  /** Whether some shift by one tick more is known to fail; false where there were too many to try. */
  readonly decided: boolean;
  /** Two for each hold: press, release. */
  readonly slack: readonly EdgeSlack[];
}

export interface RobustnessOptions extends SampleOptions {
  /** How many runs the certificate may take; beyond them it may be lower than it could be. */
  readonly maxRuns?: number;
}

/** Slack, certificate and success under noise of a run, from the start of the scene. */
export const measureRobustness = (
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  options: RobustnessOptions = {},
): Robustness => finish(measureRobustnessInSteps(scene, holds, goal, options));

/** {@link measureRobustness}, some runs a step. */
export function* measureRobustnessInSteps(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  { samples = DEFAULT_SAMPLES, seed = 0, maxRuns }: RobustnessOptions = {},
): Steps<Robustness> {
  const trials = createTrials(scene, goal);
  const joined = joinHolds(holds);
  function* under(sigma: number): Steps<Success> {
    return toSuccess(sigma, yield* countInSteps(trials, joined, tickNoise(sigma), seed, 0, samples), samples);
  }
  const { ticks, exhausted } = yield* certifyInSteps(trials, joined, maxRuns);
  return {
    p30: yield* under(30),
    p40: yield* under(40),
    p60: yield* under(60),
    p80: yield* under(80),
    certifiedTicks: ticks,
    decided: !exhausted,
    slack: yield* slackOf(trials, joined, SLACK_LIMIT),
  };
}
