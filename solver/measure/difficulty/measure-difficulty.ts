import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createSolver } from '../../search/solve/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../verified-run.ts';
import { createPlayers, type PlayerForecast } from '../player/index.ts';
import {
  BRIEF_CERTIFY_RUNS,
  type EdgeSlack,
  measureRobustness,
  type Robustness,
  type Success,
  successProbability,
} from '../robustness/index.ts';
import { type Grade, type GradeInput, gradeOf } from './grade.ts';
import { asGiven, type ComparedRun, compareRuns, findRuns } from './level-runs.ts';
import { playAtRandom, type RandomPlay } from './luck.ts';
import { findShortcuts, type Shortcuts } from './shortcuts.ts';
import { findSigmaAtHalf, type SigmaAtHalf, sigmaAtHalfOf } from './sigma-at-half.ts';

/** What collecting all minerals costs in addition: the best known run with all of them compared with the measured run. */
export interface MineralsExtra {
  /** The run with all minerals. */
  readonly run: Candidate;
  /** How much longer it takes, s; negative when it is quicker. */
  readonly time: number;
  /** How many more presses it has. */
  readonly presses: number;
  /** Its success under timing noise of 40 ms minus that of the measured run, -1 to 1. */
  readonly p40: number;
}

/** All runs that were compared. */
export interface RunComparison {
  /** Each of them, the one that forgives most first: it is the measured run. */
  readonly runs: readonly ComparedRun[];
  /** The mean of their success under timing noise of 40 ms, 0 to 1. */
  readonly meanP40: number;
  /** The mean of their grades. */
  readonly meanGrade: number;
}

/** How hard a level is, in numbers. */
export interface Difficulty {
  /** The run that was measured: of those compared, the one that forgives most. */
  readonly run: Candidate;
  /** The runs that were compared, measured briefly; only the given one if one was given. */
  readonly comparison: RunComparison;
  /** How robust the run is. */
  readonly robustness: Robustness;
  /** The timing noise at which half of all attempts succeed. */
  readonly sigmaAtHalf: SigmaAtHalf;
  /** How far the tightest press or release can move in total, earlier plus later, ticks; null for a run without presses. */
  readonly smallestWindow: number | null;
  /** The number of presses. */
  readonly presses: number;
  /** Length of the run, s. */
  readonly length: number;
  /** How often random play meets the goal. */
  readonly randomPlay: RandomPlay;
  /**
   * What collecting all minerals costs; null when the level has no minerals, the goal already requires them all, or no run with
   * all of them was found.
   */
  readonly mineralsExtra: MineralsExtra | null;
  /** Simple runs that complete the level as well. */
  readonly shortcuts: Shortcuts;
  /** What the uncalibrated model of players expects who aim at the run; null if nothing was to be spent on it. */
  readonly forecast: PlayerForecast | null;
  /** The estimated grade: the lowest that any of the compared runs gives, which is mostly that of the measured run. */
  readonly grade: Grade;
}

/** What {@link measureDifficulty} measures and what it may spend. */
export interface DifficultyOptions {
  /** What a run has to achieve; by default only the black hole. */
  readonly goal?: Goal;
  /** Attempts to simulate for each probability; 1000 by default. */
  readonly samples?: number;
  /** Random games to play; 2000 by default. */
  readonly games?: number;
  /** Seed of all random choices; 0 by default. */
  readonly seed?: number;
  /** The longest a run may last, ticks; that of the scene by default. */
  readonly maxTicks?: number;
  /**
   * Ticks to spend on finding runs; 5,000,000 by default. Half of them are for the runs that forgive most when none is given, half for
   * one with all minerals.
   */
  readonly effort?: number;
  /** Ticks to spend on synthetic players; 2,000,000 by default, 0 leaves them out. */
  readonly playerEffort?: number;
  /** Runs to compare instead of searching for them, each [press, release) in ticks; those that miss the goal are skipped. */
  readonly runs?: readonly (readonly Hold[])[];
  /** Ticks to spend on avoiding each asteroid that the run uses; 1,000,000 by default, 0 skips this question. */
  readonly asteroidEffort?: number;
  /** Single presses are tried at multiples of this many ticks; by default 1, every tick. */
  readonly onePressStride?: number;
}

/** Ticks to spend on finding a run by default. */
export const SOLVE_EFFORT = 5_000_000;

/** Ticks to spend on synthetic players by default: about 300 players, ten attempts each. */
export const PLAYER_EFFORT = 2_000_000;

const ANY: Goal = { minerals: 'any' };

/**
 * Measures how hard a level is. It compares the runs that are known and measures the one that forgives most: success under timing noise, the noise at which half of all attempts succeed, the slack of each edge, the share of random play that wins, how
 * synthetic players fare, and the simple runs that complete the level ({@link findShortcuts}). The grade is a formula over these
 * numbers; where another of the runs gives a lower one, that is the grade. The certificate of the run may take {@link BRIEF_CERTIFY_RUNS} runs, and says when that was too few.
 * @param scene the compiled level
 * @param holds the run to measure, [press, release) in ticks; null compares the level's own runs and those that a search finds
 * @param options the goal, the seed and what to spend
 * @returns the measurements, or null when the given run misses the goal or none was found within the effort
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { measureDifficulty } from 'gravity-quest-toolkit/solver';
 *
 * const difficulty = measureDifficulty(compile(level), null, { effort: 2_000_000 });
 * if (difficulty !== null) console.log(difficulty.grade.value, difficulty.grade.word);
 * ```
 */
export function measureDifficulty(
  scene: Scene,
  holds: readonly Hold[] | null,
  options: DifficultyOptions = {},
): Difficulty | null {
  const {
    goal = ANY,
    samples = 1000,
    games = 2000,
    seed = 0,
    maxTicks = maxTicksOf(scene.terms),
    effort = SOLVE_EFFORT,
  } = options;
  const found = holds === null ? (options.runs ?? findRuns(scene, goal, { effort, seed, maxTicks }).runs) : [holds];
  if (!found.some((own) => asGiven(scene, own, goal, maxTicks) !== null)) return null;

  const randomPlay = playAtRandom(scene, goal, { samples: games, seed, maxTicks });
  const runs = compareRuns(scene, found, goal, { samples, seed, maxTicks, randomShare: randomPlay.share });
  const [{ run }] = runs;
  const robustness = measureRobustness(scene, run.holds, goal, { samples, seed, maxRuns: BRIEF_CERTIFY_RUNS });
  const { p30, p40, p60, p80 } = robustness;
  const sigmaAtHalf = findSigmaAtHalf(scene, run.holds, goal, { samples, seed, known: [p30, p40, p60, p80] });
  const presses = run.holds.length;
  return {
    run,
    comparison: { runs, meanP40: meanOf(runs.map((own) => own.p40)), meanGrade: meanOf(runs.map((own) => own.grade)) },
    robustness,
    sigmaAtHalf,
    smallestWindow: smallestWindow(robustness.slack),
    presses,
    length: run.time,
    randomPlay,
    mineralsExtra: measureMinerals(scene, run, robustness.p40, { goal, samples, effort: effort / 2, seed, maxTicks }),
    shortcuts: findShortcuts(scene, goal, {
      run: run.holds,
      effort: options.asteroidEffort,
      stride: options.onePressStride,
      seed,
      maxTicks,
    }),
    forecast: forecastOf(scene, run.holds, goal, { effort: options.playerEffort ?? PLAYER_EFFORT, seed, maxTicks }),
    grade: lowestGrade(scene, goal, runs, {
      p40: robustness.p40.p,
      sigmaAtHalf: sigmaAtHalf.ms,
      presses,
      seconds: run.time,
      randomShare: randomPlay.share,
      samples,
      seed,
    }),
  };
}

/** The grade of the first run, or of one that was graded lower when they were compared, if that holds with all samples. */
function lowestGrade(
  scene: Scene,
  goal: Goal,
  runs: readonly ComparedRun[],
  { samples, seed, ...first }: GradeInput & { readonly samples: number; readonly seed: number },
): Grade {
  const lowest = runs.reduce((a, b) => (b.grade < a.grade ? b : a));
  const own = gradeOf(first);
  if (lowest === runs[0]) return own;
  const { holds, time } = lowest.run;
  const p40 = successProbability(scene, holds, goal, 40, { samples, seed });
  const sigmaAtHalf = sigmaAtHalfOf(scene, holds, goal, { samples, seed, known: [p40] });
  const other = gradeOf({ ...first, p40: p40.p, sigmaAtHalf, presses: holds.length, seconds: time });
  return other.value < own.value ? other : own;
}

const meanOf = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;

interface Budget {
  readonly effort: number;
  readonly seed: number;
  readonly maxTicks: number;
}

function forecastOf(scene: Scene, holds: readonly Hold[], goal: Goal, { effort, seed, maxTicks }: Budget): PlayerForecast | null {
  if (effort === 0) return null;
  const players = createPlayers(scene, holds, goal, { seed, maxTicks });
  players.advance(effort);
  return players.forecast();
}

/** Finds the most robust run. The search starts from the level's own runs. */
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
