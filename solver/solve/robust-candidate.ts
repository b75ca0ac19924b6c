import type { Hold } from '../../schema/basics/index.ts';
import {
  clustersOf,
  countSuccesses,
  extremeNoise,
  ShiftBox,
  type Success,
  shiftsUpTo,
  tickNoise,
  toSuccess,
} from '../robustness/index.ts';
import type { Candidate } from '../verified-run.ts';
import { shiftToMean } from './local-search.ts';
import { robustScore, type Solution } from './solution.ts';
import { playable, type SolverSession } from './solver-session.ts';

/** Noise by which runs are judged, ms. */
export const SIGMA = 40;

/** The shifts that a solution's certificate covers, ticks. */
const CERTIFIED_TICKS = 2;

/** Attempts by which runs are compared, with the same noise for all runs. */
const COMPARED = 192;
const COMPARED_SEED = 1;

/** Attempts that give the reported success. They differ from those by which the run was moved and compared. */
const REPORTED = 1000;
const REPORTED_SEED = 2;

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
  /** Attempts used for polishing, and the number of polishes in a row without a gain. */
  used: number;
  idle: number;
  certificate: Certificate;
  reported: Success | null;
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
  return { ...run, p: compared(session, run.holds), used: 0, idle: 0, certificate: 'unknown', reported: null, seed };
}

const compared = (session: SolverSession, holds: readonly Hold[]): number =>
  countSuccesses(session.trials, holds, noise, COMPARED_SEED, 0, COMPARED) / COMPARED;

/** Moves the edges to where noise does less harm. */
export function polish(session: SolverSession, candidate: RobustCandidate): void {
  const samples = 64;
  const steps = 3;
  const holds = shiftToMean(session.trials, candidate.holds, noise, {
    seed: candidate.seed,
    from: candidate.used,
    samples,
    steps,
  });
  candidate.used += samples * steps;
  const run = playable(session, holds);
  const p = run === null ? 0 : compared(session, run.holds);
  if (run === null || p <= candidate.p + GAIN) {
    candidate.idle++;
    return;
  }
  Object.assign(candidate, run, { p, idle: 0, certificate: 'unknown', reported: null });
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

/** The solution to report. Its success is measured on attempts that had no part in choosing it. */
export function toSolution(session: SolverSession, candidate: RobustCandidate): Solution {
  candidate.reported ??= toSuccess(
    SIGMA,
    countSuccesses(session.trials, candidate.holds, noise, REPORTED_SEED, 0, REPORTED),
    REPORTED,
  );
  const certified = candidate.certificate === 'proved';
  const score = robustScore(candidate.reported.p, certified);
  return { ...candidate.verified, holds: candidate.holds, score, p40: candidate.reported, certified };
}
