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
import { shiftToMean } from './basin.ts';
import { type Desk, playable } from './desk.ts';
import { robustScore, type Solution } from './solution.ts';

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
type Certificate = 'unknown' | 'proved' | 'refuted' | 'too dear';

/** One of the best runs so far. */
export interface Elite {
  holds: Hold[];
  candidate: Candidate;
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
export function createElite(desk: Desk, holds: readonly Hold[], seed: number): Elite | null {
  const run = playable(desk, holds);
  if (run === null) return null;
  return { ...run, p: compared(desk, run.holds), used: 0, idle: 0, certificate: 'unknown', reported: null, seed };
}

const compared = (desk: Desk, holds: readonly Hold[]): number =>
  countSuccesses(desk.trials, holds, noise, COMPARED_SEED, 0, COMPARED) / COMPARED;

/** Moves the edges to where noise does less harm, if they aren't there yet. */
export function polish(desk: Desk, elite: Elite): void {
  const samples = 64;
  const steps = 3;
  const holds = shiftToMean(desk.trials, elite.holds, noise, { seed: elite.seed, from: elite.used, samples, steps });
  elite.used += samples * steps;
  const run = playable(desk, holds);
  const p = run === null ? 0 : compared(desk, run.holds);
  if (run === null || p <= elite.p + GAIN) {
    elite.idle++;
    return;
  }
  Object.assign(elite, run, { p, idle: 0, certificate: 'unknown', reported: null });
}

/** The same way with its edges in the middle of where extreme shifts succeed; null when it forgives noise much less. */
export function centred(desk: Desk, elite: Elite): Elite | null {
  const extreme = extremeNoise(CERTIFIED_TICKS);
  const holds = shiftToMean(desk.trials, elite.holds, extreme, { seed: elite.seed, from: 0, samples: 64, steps: 8 });
  const moved = createElite(desk, holds, elite.seed);
  return moved === null || moved.p < elite.p - 0.03 ? null : moved;
}

/**
 * Tries to prove that all shifts by two ticks succeed, as long as that takes no more than so many ticks of simulation.
 * Yields between goes.
 */
export function* certifyElite(desk: Desk, elite: Elite, mostTicks: number): Generator<void, Certificate> {
  const { trials } = desk;
  const { holds } = elite;
  const { tick } = elite.candidate;
  if (holds.length === 0) return 'proved';
  const before = trials.ticks;
  for (const shifts of [[-CERTIFIED_TICKS, CERTIFIED_TICKS], shiftsUpTo(CERTIFIED_TICKS)]) {
    const edges = holds.flat().filter((edge) => edge <= tick);
    const last = edges[edges.length - 1];
    let combinations = tick - last + 1;
    for (let i = 0; i < edges.length; i++) combinations *= shifts.length;
    const clusters = combinations > mostTicks ? null : clustersOf(holds, CERTIFIED_TICKS, shifts, mostTicks);
    if (clusters === null) return 'too dear';
    const box = new ShiftBox(trials, clusters);
    for (;;) {
      const result = box.run(GO);
      if (result === 'proved') break;
      if (result !== 'unfinished') return 'refuted';
      if (trials.ticks - before > 2 * mostTicks) return 'too dear';
      yield;
    }
  }
  return 'proved';
}

/** What runs are sorted by. */
export const standing = (elite: Elite): number => robustScore(elite.p, elite.certificate === 'proved');

/** What is said of it: its success in executions that played no part in choosing it. */
export function toSolution(desk: Desk, elite: Elite): Solution {
  elite.reported ??= toSuccess(SIGMA, countSuccesses(desk.trials, elite.holds, noise, REPORTED_SEED, 0, REPORTED), REPORTED);
  const certified = elite.certificate === 'proved';
  const score = robustScore(elite.reported.p, certified);
  return { ...elite.candidate, holds: elite.holds, score, p40: elite.reported, certified };
}
