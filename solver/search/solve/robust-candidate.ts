import type { Hold } from '../../../schema/basics/index.ts';
import {
  clustersOf,
  countSuccesses,
  extremeNoise,
  FIRST_TO_CHOOSE_BY,
  ShiftBox,
  shiftsUpTo,
  tickNoise,
  toSuccess,
} from '../../measure/robustness/index.ts';
import type { Candidate } from '../../verified-run.ts';
import { shiftToMean } from './local-search.ts';
import { robustScore, type Solution } from './solution.ts';
import { playable, type SolverSession } from './solver-session.ts';

/** Noise by which runs are judged, ms. */
export const SIGMA = 40;

/** The shifts that a solution's certificate covers, ticks. */
const CERTIFIED_TICKS = 2;

/** Attempts by which runs are compared, with the same noise for all runs: at first, and before a run is reported. */
const COMPARED = 192;
const SURE = 960;
const COMPARED_SEED = 1;

/** Attempts that give the reported success. Nothing is chosen by them. */
const REPORTED = 1000;

/** Attempts of one step of a polish. After a polish without a gain the next one measures its steps better. */
const POLISH_SAMPLES = [64, 192];
const POLISH_STEPS = 3;

/** A polish must raise success by more than this to count. */
const GAIN = 0.002;

/** Runs of a certificate that are simulated per call. */
const GO = 1000;

/** The state of a run's certificate. */
type Certificate = 'unknown' | 'proved' | 'refuted' | 'too expensive';

/** One of the best runs so far. */
export interface RobustCandidate {
  holds: Hold[];
  /** The replay of the run from the start. */
  verified: Candidate;
  /** Share of the compared attempts that met the goal. */
  p: number;
  /** How many attempts were compared, and how many of the first `COMPARED` of them met the goal. */
  tested: number;
  early: number;
  /** Attempts used for polishing, and the number of polishes in a row without a gain. */
  used: number;
  idle: number;
  certificate: Certificate;
  readonly seed: number;
}

const noise = tickNoise(SIGMA);

/**
 * Measures a run.
 * @returns null when the run itself fails
 */
export function createRobustCandidate(session: SolverSession, holds: readonly Hold[], seed: number): RobustCandidate | null {
  const run = playable(session, holds);
  if (run === null) return null;
  const early = succeeding(session, run.holds, 0, COMPARED);
  return { ...run, p: early / COMPARED, tested: COMPARED, early, used: 0, idle: 0, certificate: 'unknown', seed };
}

/** Successes among the attempts `from` to `to` of those that all runs are compared by. */
const succeeding = (session: SolverSession, holds: readonly Hold[], from: number, to: number): number =>
  countSuccesses(session.trials, holds, noise, COMPARED_SEED, FIRST_TO_CHOOSE_BY + from, FIRST_TO_CHOOSE_BY + to);

/** Whether a run was compared by enough attempts to be reported. */
export const isSure = ({ tested }: RobustCandidate): boolean => tested === SURE;

/** Compares a run by as many attempts as one that is reported. */
export function makeSure(session: SolverSession, candidate: RobustCandidate): void {
  const { holds, p, tested } = candidate;
  candidate.p = (Math.round(p * tested) + succeeding(session, holds, tested, SURE)) / SURE;
  candidate.tested = SURE;
}

/** Moves the edges to where noise does less harm. */
export function polish(session: SolverSession, candidate: RobustCandidate): void {
  const samples = POLISH_SAMPLES[Math.min(candidate.idle, POLISH_SAMPLES.length - 1)];
  const holds = shiftToMean(session.trials, candidate.holds, noise, {
    seed: candidate.seed,
    from: candidate.used,
    samples,
    steps: POLISH_STEPS,
  });
  candidate.used += samples * POLISH_STEPS;
  candidate.idle++;
  const moved = createRobustCandidate(session, holds, candidate.seed);
  if (moved === null || moved.early < candidate.early) return;
  if (isSure(candidate)) makeSure(session, moved);
  if (moved.p <= candidate.p + GAIN) return;
  Object.assign(candidate, moved, { used: candidate.used });
}

/**
 * The same way through the level with its edges centred between the extreme shifts that succeed; null when success drops by
 * more than 0.03.
 */
export function centred(session: SolverSession, candidate: RobustCandidate): RobustCandidate | null {
  const extreme = extremeNoise(CERTIFIED_TICKS);
  const holds = shiftToMean(session.trials, candidate.holds, extreme, { seed: candidate.seed, from: 0, samples: 64, steps: 8 });
  const moved = createRobustCandidate(session, holds, candidate.seed);
  return moved === null || moved.p < candidate.p - 0.03 ? null : moved;
}

/**
 * Tries to prove that all shifts by up to two ticks succeed. Yields between calls.
 * @param mostTicks the most ticks to simulate, about; beyond them the certificate is too expensive
 */
export function* certifyCandidate(
  session: SolverSession,
  candidate: RobustCandidate,
  mostTicks: number,
): Generator<void, Certificate> {
  const { trials } = session;
  const { holds } = candidate;
  const { tick } = candidate.verified;
  if (holds.length === 0) return 'proved';
  const before = trials.ticks;
  for (const shifts of [[-CERTIFIED_TICKS, CERTIFIED_TICKS], shiftsUpTo(CERTIFIED_TICKS)]) {
    const edges = holds.flat().filter((edge) => edge <= tick);
    const last = edges[edges.length - 1];
    let combinations = tick - last + 1;
    for (let i = 0; i < edges.length; i++) combinations *= shifts.length;
    const clusters = combinations > mostTicks ? null : clustersOf(holds, CERTIFIED_TICKS, shifts, mostTicks);
    if (clusters === null) return 'too expensive';
    const box = new ShiftBox(trials, clusters);
    for (;;) {
      const result = box.run(GO);
      if (result === 'proved') break;
      if (result !== 'unfinished') return 'refuted';
      if (trials.ticks - before > 2 * mostTicks) return 'too expensive';
      yield;
    }
  }
  return 'proved';
}

/** The score by which candidates are ordered. */
export const standing = (candidate: RobustCandidate): number => robustScore(candidate.p, candidate.certificate === 'proved');

/** The solution to report, without a measured success. */
export function toSolution(candidate: RobustCandidate): Solution {
  return {
    ...candidate.verified,
    holds: candidate.holds,
    score: standing(candidate),
    p40: null,
    certified: candidate.certificate === 'proved',
  };
}

/**
 * Measures the success of a solution that has been chosen, by the attempts of {@link measureRobustness} with the same seed.
 * Nothing is chosen by the result, so it is as often too low as too high.
 */
export function measured(session: SolverSession, solution: Solution): Solution {
  const successes = countSuccesses(session.trials, solution.holds, noise, session.seed, 0, REPORTED);
  return { ...solution, p40: toSuccess(SIGMA, successes, REPORTED) };
}
