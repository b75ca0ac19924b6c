import { compile, createSimulation, type Scene } from '../../engine/index.ts';
import {
  countOnePress,
  findSigmaAtHalf,
  type Grade,
  gradeOf,
  type OnePressCount,
  playAtRandom,
  playGameAtRandom,
} from '../difficulty/index.ts';
import type { Goal } from '../goal.ts';
import type { Random } from '../random.ts';
import { successProbability } from '../robustness/index.ts';
import { createSolver } from '../solve/index.ts';
import { type Candidate, DEFAULT_MAX_TICKS, verifyRun } from '../verified-run.ts';
import type { Layout } from './layout.ts';
import { toLevel } from './level-file.ts';
import { type Way, wayOf } from './tube.ts';

/** Reach the black hole. */
export const ANY: Goal = { minerals: 'any' };
/** Reach the black hole with all minerals. */
export const ALL: Goal = { minerals: 'all' };

// Ticks simulated between two yields.
const SLICE = 100_000;

// Ticks to find runs through a level, or one that collects all minerals.
const SOLVE_EFFORT = 800_000;

const SAMPLES = 300;
const GAMES = 400;

// Every third tick suffices to estimate the share of single presses that win.
const STRIDE = 3;

/**
 * The scene for quick measurements, at `arcade`, which is the fastest. What is claimed in the end is measured in continuous
 * time as well.
 */
export const sceneOf = (layout: Layout): Scene => compile(toLevel(layout), 'arcade');

/**
 * Finds different runs that meet a goal, the most robust first. Each also wins at `precise`.
 * @param effort most ticks
 * @param known runs to start from
 */
export function* findWays(
  scene: Scene,
  goal: Goal,
  seed: number,
  effort: number = SOLVE_EFFORT,
  known: readonly Candidate[] = [],
): Generator<number, Candidate[]> {
  const solver = createSolver(scene, { goal, seed, count: 4, known: known.map(({ holds }) => holds) });
  while (solver.effort.ticks < effort && !solver.finished) {
    const before = solver.effort.ticks;
    solver.advance(SLICE);
    yield solver.effort.ticks - before;
  }
  const precise = compile(scene.level);
  return solver.solutions.filter(({ holds }) => verifyRun(precise, holds, goal) !== null);
}

/** Sorts runs by success under timing noise of 40 ms, the most robust first. */
export function sortByP40(scene: Scene, runs: readonly Candidate[]): Candidate[] {
  const p40 = (run: Candidate) => successProbability(scene, run.holds, ANY, 40, { samples: SAMPLES, seed: 1 }).p;
  const valued = runs.map((run) => ({ run, p: p40(run) }));
  return valued.sort((a, b) => b.p - a.p).map(({ run }) => run);
}

/** The grade of a level by its best known run. */
export function gradeRun(scene: Scene, run: Candidate, seed: number): Grade {
  const options = { samples: SAMPLES, seed };
  return gradeOf({
    p40: successProbability(scene, run.holds, ANY, 40, options).p,
    sigmaAtHalf: findSigmaAtHalf(scene, run.holds, ANY, options).ms,
    presses: run.holds.length,
    seconds: run.time,
    randomShare: playAtRandom(scene, ANY, { samples: GAMES, seed, maxTicks: DEFAULT_MAX_TICKS }).share,
  });
}

/** What single presses within the length of a run achieve, sampled with a stride. */
export const scoutOnePress = (scene: Scene, run: Candidate): OnePressCount =>
  countOnePress(scene, ANY, run.tick + 1, DEFAULT_MAX_TICKS, STRIDE);

/** A few paths on which random play reached the black hole. */
export function luckyWays(scene: Scene, most: number, random: Random): Way[] {
  const simulation = createSimulation(scene);
  const ways: Way[] = [];
  for (let game = 0; game < GAMES && ways.length < most; game++) {
    const holds = playGameAtRandom(simulation, random, DEFAULT_MAX_TICKS);
    if (simulation.ending?.outcome === 'completed') ways.push(wayOf(scene, holds));
  }
  return ways;
}
