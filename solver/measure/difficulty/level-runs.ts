import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Closest, Effort } from '../../search/explore/index.ts';
import { createSolver } from '../../search/solve/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../verified-run.ts';
import { successProbability } from '../robustness/index.ts';
import { gradeOf, hardnessOf, strictnessOf } from './grade.ts';
import { sigmaAtHalfOf } from './sigma-at-half.ts';

/** Runs that meet a goal, to be compared. */
export interface FoundRuns {
  /** The level's own runs that meet the goal, then those that the search found; no two are the same. */
  readonly runs: readonly (readonly Hold[])[];
  /** What the search has cost. */
  readonly effort: Effort;
  /** How near the search came to the black hole; null if nothing was simulated. */
  readonly closest: Closest | null;
}

/** How many different runs the search returns at most. */
const FOUND = 3;

/**
 * Finds the runs that forgive most, beginning with the level's own. Half of the effort is for that; the other half is spent only if
 * there is no run by then.
 * @param scene the compiled level
 * @param goal what a run has to achieve
 * @param options ticks to simulate at most, the seed of the search, and the longest that a run may last in ticks
 */
export function findRuns(
  scene: Scene,
  goal: Goal,
  options: {
    /** Ticks to simulate at most. */
    readonly effort: number;
    /** Seed of the search, a whole number. */
    readonly seed: number;
    /** The longest a run may last, ticks. */
    readonly maxTicks: number;
  },
): FoundRuns {
  const { effort, seed, maxTicks } = options;
  const known = scene.level.runs.map(({ holds }) => holds).filter((holds) => verifyRun(scene, holds, goal, maxTicks) !== null);
  const solver = createSolver(scene, { goal, seed, maxTicks, objective: 'robust', count: FOUND, known });
  solver.advance(Math.ceil(effort / 2));
  if (solver.best === null && known.length === 0) solver.advance(Math.floor(effort / 2));
  const runs = new Map([...known, ...solver.solutions.map(({ holds }) => holds)].map((holds) => [JSON.stringify(holds), holds]));
  return { runs: [...runs.values()], effort: solver.effort, closest: solver.closest };
}

/** One of the runs that were compared, measured briefly. */
export interface ComparedRun {
  /** The run. Its last hold may go on beyond the end, as a player would hold on. */
  readonly run: Candidate;
  /** Success under timing noise of 40 ms, 0 to 1. */
  readonly p40: number;
  /** The timing noise at which half of all attempts succeed, ms; at most 500. */
  readonly sigmaAtHalf: number;
  /** The grade that the level would have if this were its only run. */
  readonly grade: number;
}

/** Attempts for each probability where runs are only compared. */
const SAMPLES = 250;

/** A run with the holds as they were given, so that a hold beyond the end stays one. */
export function asGiven(scene: Scene, holds: readonly Hold[], goal: Goal, maxTicks: number): Candidate | null {
  const run = verifyRun(scene, holds, goal, maxTicks);
  if (run === null) return null;
  return { ...run, holds: joinHolds(holds).filter(([press]) => press <= run.tick) };
}

/**
 * Compares runs: the one that forgives most first. All of them are measured under the same noise.
 * @param randomShare how often random play wins, for the grade
 */
export function compareRuns(
  scene: Scene,
  runs: readonly (readonly Hold[])[],
  goal: Goal,
  options: { readonly samples: number; readonly seed: number; readonly maxTicks: number; readonly randomShare: number },
): ComparedRun[] {
  const { seed, maxTicks, randomShare } = options;
  const samples = Math.min(options.samples, SAMPLES);
  const measured = runs.flatMap((holds) => {
    const run = asGiven(scene, holds, goal, maxTicks);
    if (run === null) return [];
    const p40 = successProbability(scene, run.holds, goal, 40, { samples, seed, maxTicks });
    const sigmaAtHalf = sigmaAtHalfOf(scene, run.holds, goal, { samples, seed, known: [p40] });
    const input = { p40: p40.p, sigmaAtHalf, presses: run.holds.length, seconds: run.time, randomShare };
    return [{ input, own: { run, p40: p40.p, sigmaAtHalf, grade: gradeOf(input).value } }];
  });
  measured.sort((a, b) => strictnessOf(a.input) - strictnessOf(b.input) || hardnessOf(a.input) - hardnessOf(b.input));
  return measured.map(({ own }) => own);
}
