import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import type { Goal } from '../../verified-run.ts';
import { certifyInSteps } from './certify.ts';
import { type EdgeSlack, SLACK_LIMIT, slackOf } from './slack.ts';
import { countInSteps, DEFAULT_SAMPLES, type SampleOptions, type Success, toSuccess } from './success-probability.ts';
import { tickNoise } from './tick-noise.ts';
import { createTrials } from './trials.ts';

/** How robust a run is. */
export interface Robustness {
  /** Success under timing noise with a standard deviation of 30 ms per edge. */
  readonly p30: Success;
  /** Success under timing noise with a standard deviation of 40 ms per edge. */
  readonly p40: Success;
  /** Success under timing noise with a standard deviation of 60 ms per edge. */
  readonly p60: Success;
  /** Success under timing noise with a standard deviation of 80 ms per edge. */
  readonly p80: Success;
  /** All combinations of shifts of all presses and releases by up to this many ticks meet the goal. */
  readonly certifiedTicks: number;
  /** Whether a combination of shifts by one tick more is known to fail; false when there were too many to try. */
  readonly decided: boolean;
  /** Slack of each edge, two entries per hold: press, release. */
  readonly slack: readonly EdgeSlack[];
}

/** What {@link measureRobustness} may spend. */
export interface RobustnessOptions extends SampleOptions {
  /**
   * The most runs for the certificate; 200,000 by default. When they are spent, `certifiedTicks` may be lower than possible.
   */
  readonly maxRuns?: number;
}

/**
 * Measures how robust a run is: its slack, its certified ticks and its success under timing noise.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param options samples and seed of the noise, and the limits of an attempt and of the certificate
 * @returns the measurements; for a run that misses the goal, slack and certified ticks are 0
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { measureRobustness } from 'gravity-quest-toolkit/solver';
 *
 * const { p40, certifiedTicks, slack } = measureRobustness(compile(level), [[12, 96]], { minerals: 'any' });
 * console.log(`${(100 * p40.p).toFixed(0)} % succeed at 40 ms; ${certifiedTicks} ticks are certified`);
 * ```
 */
export const measureRobustness = (
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  options: RobustnessOptions = {},
): Robustness => finish(measureRobustnessInSteps(scene, holds, goal, options));

/**
 * {@link measureRobustness} in steps of a few runs, for callers that must stay responsive.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks; joined where they overlap
 * @param goal what the run has to achieve
 * @param options samples and seed of the noise, and the limits of an attempt and of the certificate
 * @returns a generator that yields between steps and returns the measurements
 */
export function* measureRobustnessInSteps(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  { samples = DEFAULT_SAMPLES, seed = 0, maxTicks, maxRuns }: RobustnessOptions = {},
): Steps<Robustness> {
  const trials = createTrials(scene, goal, maxTicks);
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
