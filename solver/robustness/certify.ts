import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { finish, type Steps } from '../steps.ts';
import { type BoxResult, type Cluster, clustersInSteps, ShiftBox, shiftsUpTo } from './shift-box.ts';
import { SLACK_LIMIT } from './slack.ts';
import { createTrials, playFrom, type Trials } from './trials.ts';

/** Runs tried when nothing else is said: enough for two ticks and three holds, or four of which the last lasts to the end. */
const DEFAULT_CERTIFY_RUNS = 200_000;

/** Runs tried where somebody waits for the certificate, or many levels are measured: a tick more is seldom worth ten times as many. */
export const BRIEF_CERTIFY_RUNS = 20_000;

/** Few enough for a step of some ms in a large level. */
const RUNS_A_STEP = 8;

/** By how much k grows from one box to the next: the boxes before the last cost little then. */
const GROWTH = 1.5;

export interface CertifyOptions {
  /** Ticks after which a run that goes on has failed; a minute when left out. */
  readonly maxTicks?: number;
  /** Runs tried at most; 200,000 when left out. */
  readonly maxRuns?: number;
  /** No more than this is proven, ticks; 60 when left out. */
  readonly limit?: number;
}

/** What was proven by trying every combination. */
export interface Certification {
  /** The largest k proven: ALL combinations of shifts of every edge by up to k ticks meet the goal. */
  readonly ticks: number;
  /** True when `maxRuns` ran out before k + 1 was decided. */
  readonly exhausted: boolean;
  /** Runs simulated. */
  readonly runs: number;
  /** A run with shifts of up to k + 1 ticks (or none, when k is 0 and the run itself fails) that fails; null when none was found. */
  readonly counterexample: Hold[] | null;
}

/**
 * Proves how far all edges can move together. Exact: every combination is simulated, with what combinations share
 * simulated once. Shifted edges are read as in `shiftHolds`, so holds that overlap join, and empty ones vanish.
 */
export function certify(scene: Scene, holds: readonly Hold[], goal: Goal, options: CertifyOptions = {}): Certification {
  return certifyWith(createTrials(scene, goal, options.maxTicks), joinHolds(holds), options.maxRuns, options.limit);
}

/** {@link certify} on trials at hand. @param holds sorted and disjoint */
export const certifyWith = (trials: Trials, holds: readonly Hold[], maxRuns?: number, limit?: number): Certification =>
  finish(certifyInSteps(trials, holds, maxRuns, limit));

/** {@link certifyWith}, some runs a step. */
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
  // without an edge there is nothing to shift: proven for every k
  if (holds.length === 0) return stop(limit, null, false);
  const leftOver = () => before + maxRuns - trials.runs;

  /** @param whole do not begin what can't be finished */
  function* judge(k: number, whole: boolean): Steps<BoxResult> {
    // all edges at their extremes fail most often and are few: they are tried before everything else
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
  // the smallest k that is known to fail, and the smallest that takes too many runs; beyond the limit as long as there is none
  let refuted = limit + 1;
  let tooMany = limit + 1;
  let failed: Hold[] | null = null;
  // what holds for k holds for less: in growing steps as long as nothing stops it, then by halves
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
    // what is left may still find one that fails
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

/** At most so many runs are simulated for all combinations. */
const combinationsOf = (clusters: readonly Cluster[]): number => clusters.reduce((product, { ways }) => product * ways.length, 1);
