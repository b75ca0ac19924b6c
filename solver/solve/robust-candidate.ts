import type { Hold } from '../../schema/index.ts';
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

/** Noise that runs are judged by, ms. */
export const SIGMA = 40;

/** Shifts a certificate is sought for, ticks. */
const CERTIFIED_TICKS = 2;

/** Executions in which runs are compared; all runs stumble alike in them. */
const COMPARED = 192;
const COMPARED_SEED = 1;

/** Executions that tell what a run is worth in the end: others than it was moved and compared by. */
const REPORTED = 1000;
const REPORTED_SEED = 2;

/** A polish that brings less than this is as good as none. */
const GAIN = 0.002;

/** Runs of a certificate that are tried in one go. */
const GO = 1000;

/** What is known about a certificate of a run. */
type Certificate = 'unknown' | 'proved' | 'refuted' | 'too expensive';

/** One of the best runs so far. */
export interface RobustCandidate {
  holds: Hold[];
  /** Its replay from the start. */
  verified: Candidate;
  /** Share of the compared executions that met the goal. */
  p: number;
  /** Executions used up in polishing, and polishes in a row that brought nothing. */
  used: number;
  idle: number;
  certificate: Certificate;
  reported: Success | null;
  readonly seed: number;
}

const noise = tickNoise(SIGMA);

/** @returns null when the run itself fails */
export function createRobustCandidate(session: SolverSession, holds: readonly Hold[], seed: number): RobustCandidate | null {
  const run = playable(session, holds);
  if (run === null) return null;
  return { ...run, p: compared(session, run.holds), used: 0, idle: 0, certificate: 'unknown', reported: null, seed };
}

const compared = (session: SolverSession, holds: readonly Hold[]): number =>
  countSuccesses(session.trials, holds, noise, COMPARED_SEED, 0, COMPARED) / COMPARED;

/** Moves the edges to where noise does less harm, if they aren't there yet. */
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

/** The same way with its edges in the middle of where extreme shifts succeed; null when it forgives noise much less. */
export function centred(session: SolverSession, candidate: RobustCandidate): RobustCandidate | null {
  const extreme = extremeNoise(CERTIFIED_TICKS);
  const holds = shiftToMean(session.trials, candidate.holds, extreme, { seed: candidate.seed, from: 0, samples: 64, steps: 8 });
  const moved = createRobustCandidate(session, holds, candidate.seed);
  return moved === null || moved.p < candidate.p - 0.03 ? null : moved;
}

/**
 * Tries to prove that all shifts by two ticks succeed, as long as that takes no more than so many ticks of simulation.
 * Yields between goes.
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

/** What runs are sorted by. */
export const standing = (candidate: RobustCandidate): number => robustScore(candidate.p, candidate.certificate === 'proved');

/** What is said of it: its success in executions that played no part in choosing it. */
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
