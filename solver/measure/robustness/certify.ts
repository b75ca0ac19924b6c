import { joinHolds, type Scene, type WorkBudget } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import type { Goal } from '../../verified-run.ts';
import { type BoxResult, type Cluster, clustersInSteps, ShiftBox, shiftsUpTo } from './shift-box.ts';
import { SLACK_LIMIT } from './slack.ts';
import { createTrials, playFrom, type Trials } from './trials.ts';

/** Default limit on the runs tried: enough for two ticks with three holds, or with four of which the last lasts to the end. */
const DEFAULT_CERTIFY_RUNS = 200_000;

/**
 * A lower limit for {@link CertifyOptions.maxRuns}, for callers that wait for the certificate or measure many levels: one more
 * certified tick is seldom worth ten times as many runs.
 */
export const BRIEF_CERTIFY_RUNS = 20_000;

/** So few that one step takes a few milliseconds in a large level. */
const RUNS_A_STEP = 8;

/** Growth of k from one attempt to the next, so that the attempts before the last one cost little. */
const GROWTH = 1.5;

/** Limits for {@link certify}. */
export interface CertifyOptions {
  /** A run fails when it lasts longer than this, ticks; that of the scene by default. */
  readonly maxTicks?: number;
  /** The most runs to simulate; 200,000 by default. */
  readonly maxRuns?: number;
  /** The largest shift to certify, ticks; 60 by default. */
  readonly limit?: number;
  /** Limits the work of all runs together; `certify` throws `WorkLimitReached` when it is used up. No limit by default. */
  readonly budget?: WorkBudget;
}

/** The result of trying every combination of shifts. */
export interface Certification {
  /**
   * Certified ticks: the largest k for which ALL combinations of shifts of all presses and releases by up to k ticks meet the
   * goal.
   */
  readonly ticks: number;
  /** True when `maxRuns` was spent before k + 1 was decided. */
  readonly exhausted: boolean;
  /** Runs simulated. */
  readonly runs: number;
  /** A failing run with shifts of up to k + 1 ticks, or the run itself if it already fails; null when none was found. */
  readonly counterexample: Hold[] | null;
}

/**
 * Certifies how far all presses and releases of a run may move at once. The result is exact: every combination of shifts is
 * simulated.
 *
 * What combinations have in common is simulated once: they are tried depth first, and each goes on from a snapshot of the state
 * at its last common edge. Extreme shifts come first, because they are the most likely to fail. Edges that shifts can bring out
 * of order are shifted together. The game then reads the holds as in `shiftHolds`: overlapping holds join and empty ones
 * vanish.
 * @param scene the compiled level
 * @param holds the run, [press, release) in ticks
 * @param goal what every shifted run has to achieve
 * @param options limits on the runs simulated, on their length and on k
 * @returns the certified ticks, and a counterexample for one tick more if one was found
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { certify } from 'gravity-quest-toolkit/solver';
 *
 * const { ticks, exhausted } = certify(compile(level), [[12, 96]], { minerals: 'any' }, { maxRuns: 20_000 });
 * ```
 */
export function certify(scene: Scene, holds: readonly Hold[], goal: Goal, options: CertifyOptions = {}): Certification {
  return certifyWith(
    createTrials(scene, goal, options.maxTicks, options.budget),
    joinHolds(holds),
    options.maxRuns,
    options.limit,
  );
}

/**
 * {@link certify} with existing trials.
 * @param holds sorted and disjoint
 */
export const certifyWith = (trials: Trials, holds: readonly Hold[], maxRuns?: number, limit?: number): Certification =>
  finish(certifyInSteps(trials, holds, maxRuns, limit));

/** {@link certifyWith}, a few runs per step. */
export function* certifyInSteps(
  trials: Trials,
  holds: readonly Hold[],
  maxRuns = DEFAULT_CERTIFY_RUNS,
  limit = SLACK_LIMIT,
): Steps<Certification> {
  const before = trials.runs;
  const stop = (ticks: number, failed: Hold[] | null, exhausted: boolean): Certification => ({
    ticks,
    exhausted,
    runs: trials.runs - before,
    counterexample: failed,
  });
  trials.simulation.reset();
  if (!playFrom(trials, trials.simulation.snapshot(), holds)) return stop(0, [...holds], false);
  // A run without edges has nothing to shift: it is certified for every k.
  if (holds.length === 0) return stop(limit, null, false);
  const leftOver = () => before + maxRuns - trials.runs;

  /** @param whole do not start what `maxRuns` cannot finish */
  function* judge(k: number, whole: boolean): Steps<BoxResult> {
    // All edges at their extremes are the few combinations that fail most often: try them before all others.
    for (const shifts of [[-k, k], shiftsUpTo(k)]) {
      const left = leftOver();
      const clusters = yield* clustersInSteps(holds, k, shifts, left);
      if (clusters === null || (whole && combinationsOf(clusters) > left)) return 'unfinished';
      const box = new ShiftBox(trials, clusters);
      for (;;) {
        const result = box.run(Math.min(RUNS_A_STEP, leftOver()));
        if (result !== 'proved' && (result !== 'unfinished' || leftOver() <= 0)) return result;
        yield null;
        if (result === 'proved') break;
      }
    }
    return 'proved';
  }

  let proved = 0;
  // The smallest k known to fail, and the smallest known to take too many runs; limit + 1 while there is none.
  let refuted = limit + 1;
  let tooMany = limit + 1;
  let failed: Hold[] | null = null;
  // What holds for k holds for every smaller one: grow k until something stops it, then bisect.
  while (proved + 1 < Math.min(refuted, tooMany)) {
    const bound = Math.min(refuted, tooMany);
    const k = bound > limit ? Math.min(limit, Math.max(proved + 1, Math.ceil(GROWTH * proved))) : (proved + bound) >> 1;
    const result = yield* judge(k, true);
    if (result === 'proved') proved = k;
    else if (result === 'unfinished') tooMany = k;
    else {
      refuted = k;
      failed = [...result];
    }
  }
  if (proved + 1 < refuted) {
    // The remaining runs may still find a counterexample.
    const result = yield* judge(proved + 1, false);
    if (result === 'proved') proved++;
    else if (result !== 'unfinished') {
      refuted = proved + 1;
      failed = [...result];
    }
  }
  const isDecided = refuted === proved + 1;
  return stop(proved, isDecided ? failed : null, !isDecided);
}

/** The most runs that all combinations can take. */
const combinationsOf = (clusters: readonly Cluster[]): number => clusters.reduce((product, { ways }) => product * ways.length, 1);
