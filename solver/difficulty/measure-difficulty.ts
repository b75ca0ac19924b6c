import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import {
  BRIEF_CERTIFY_RUNS,
  type EdgeSlack,
  measureRobustness,
  type Robustness,
  type Success,
  successProbability,
} from '../robustness/index.ts';
import { createSolver } from '../solve/index.ts';
import { type Candidate, DEFAULT_MAX_TICKS, verifyRun } from '../verified-run.ts';
import { type Grade, gradeOf } from './grade.ts';
import { playAtRandom, type RandomPlay } from './random-play.ts';
import { findShortcuts, type Shortcuts } from './shortcuts.ts';
import { findSigmaAtHalf, type SigmaAtHalf } from './sigma-at-half.ts';

/** What collecting every mineral costs more than just getting through: best known run against best known run. */
export interface MineralsExtra {
  /** The run with all minerals that was compared. */
  readonly run: Candidate;
  /** s longer; negative when the run with all of them is quicker */
  readonly time: number;
  readonly presses: number;
  /** P(40 ms) with all minerals minus P(40 ms) without them */
  readonly p40: number;
}

/** How hard a level is, in numbers. */
export interface Difficulty {
  /** The run that was measured. */
  readonly run: Candidate;
  readonly robustness: Robustness;
  readonly sigmaAtHalf: SigmaAtHalf;
  /** Ticks that the tightest press or release can move in all, earlier and later; null for a run without presses. */
  readonly smallestWindow: number | null;
  readonly presses: number;
  /** s */
  readonly length: number;
  readonly randomPlay: RandomPlay;
  /** null when the level has no minerals or no run with all of them was found */
  readonly mineralsExtra: MineralsExtra | null;
  readonly shortcuts: Shortcuts;
  /** An estimate: see `gradeOf`. */
  readonly grade: Grade;
}

export interface DifficultyOptions {
  readonly goal?: Goal;
  /** Executions tried for each probability; 1000 when left out. */
  readonly samples?: number;
  /** Random games; 2000 when left out. */
  readonly games?: number;
  readonly seed?: number;
  readonly maxTicks?: number;
  /** Ticks simulated to find the most robust run, when none is given, and likewise one with all minerals; {@link SOLVE_EFFORT} when left out. */
  readonly effort?: number;
  /** Ticks simulated to find a way without each asteroid; 0 asks about none. */
  readonly asteroidEffort?: number;
  /** Single presses are tried at multiples of so many ticks; 1, every tick, when left out. */
  readonly onePressStride?: number;
}

/** Ticks simulated to find a run where nothing else is said. */
export const SOLVE_EFFORT = 5_000_000;

const ANY: Goal = { minerals: 'any' };

/**
 * Measures how hard a level is, by a run: the given one, or the most robust one found.
 * @param holds the run to measure; null looks for one
 * @returns null when there is no run to measure: the one given does not meet the goal, or none was found within the effort
 */
export function measureDifficulty(
  scene: Scene,
  holds: readonly Hold[] | null,
  options: DifficultyOptions = {},
): Difficulty | null {
  const { goal = ANY, samples = 1000, games = 2000, seed = 0, maxTicks = DEFAULT_MAX_TICKS, effort = SOLVE_EFFORT } = options;
  const found = holds ?? mostRobust(scene, goal, { effort, seed, maxTicks });
  const run = found === null ? null : verifyRun(scene, found, goal, maxTicks);
  if (run === null) return null;

  const robustness = measureRobustness(scene, run.holds, goal, { samples, seed, maxRuns: BRIEF_CERTIFY_RUNS });
  const { p30, p40, p60, p80 } = robustness;
  const sigmaAtHalf = findSigmaAtHalf(scene, run.holds, goal, { samples, seed, known: [p30, p40, p60, p80] });
  const randomPlay = playAtRandom(scene, goal, { samples: games, seed, maxTicks });
  const presses = run.holds.length;
  return {
    run,
    robustness,
    sigmaAtHalf,
    smallestWindow: smallestWindow(robustness.slack),
    presses,
    length: run.time,
    randomPlay,
    mineralsExtra: measureMinerals(scene, run, robustness.p40, { goal, samples, effort, seed, maxTicks }),
    shortcuts: findShortcuts(scene, goal, {
      run: run.holds,
      effort: options.asteroidEffort,
      stride: options.onePressStride,
      seed,
      maxTicks,
    }),
    grade: gradeOf({
      p40: robustness.p40.p,
      sigmaAtHalf: sigmaAtHalf.ms,
      presses,
      seconds: run.time,
      randomShare: randomPlay.share,
    }),
  };
}

interface Budget {
  readonly effort: number;
  readonly seed: number;
  readonly maxTicks: number;
}

/** The level's own runs are where the search starts. */
function mostRobust(scene: Scene, goal: Goal, { effort, seed, maxTicks }: Budget): readonly Hold[] | null {
  const known = scene.level.runs.map(({ holds }) => holds);
  const solver = createSolver(scene, { goal, seed, maxTicks, objective: 'robust', known });
  solver.advance(effort);
  return solver.best?.holds ?? null;
}

function smallestWindow(slack: readonly EdgeSlack[]): number | null {
  return slack.length === 0 ? null : Math.min(...slack.map(({ earlier, later }) => earlier + later));
}

function measureMinerals(
  scene: Scene,
  run: Candidate,
  p40: Success,
  { goal, samples, ...budget }: Budget & { readonly goal: Goal; readonly samples: number },
): MineralsExtra | null {
  const all: Goal = { minerals: 'all' };
  if (scene.minerals.count === 0 || goal.minerals === 'all') return null;
  const holds = mostRobust(scene, all, budget);
  const withAll = holds === null ? null : verifyRun(scene, holds, all, budget.maxTicks);
  if (withAll === null) return null;
  const success = successProbability(scene, withAll.holds, all, p40.sigma, { samples, seed: budget.seed });
  return {
    run: withAll,
    time: withAll.time - run.time,
    presses: withAll.holds.length - run.holds.length,
    p40: success.p - p40.p,
  };
}
