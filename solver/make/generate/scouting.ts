import { compile, createSimulation, maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import {
  countOnePress,
  type Grade,
  type GradeInput,
  gradeOf,
  type OnePressCount,
  playAtRandom,
  playGameAtRandom,
  sigmaAtHalfOf,
} from '../../measure/difficulty/index.ts';
import { successProbability } from '../../measure/robustness/index.ts';
import type { Random } from '../../random.ts';
import { createSolver } from '../../search/solve/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../verified-run.ts';
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
export const gradeRun = (scene: Scene, run: Candidate, seed: number): Grade =>
  gradeOf({
    ...measureRun(scene, run, SAMPLES, seed),
    randomShare: playAtRandom(scene, ANY, { samples: GAMES, seed, maxTicks: maxTicksOf(scene.terms) }).share,
  });

/** What a grade is computed from, but for random play. */
export function measureRun(scene: Scene, run: Candidate, samples: number, seed: number): Omit<GradeInput, 'randomShare'> {
  const success = successProbability(scene, run.holds, ANY, 40, { samples, seed });
  return {
    p40: success.p,
    sigmaAtHalf: sigmaAtHalfOf(scene, run.holds, ANY, { samples, seed, known: [success] }),
    presses: run.holds.length,
    seconds: run.time,
  };
}

/** What single presses within the length of a run achieve, sampled with a stride. */
export const scoutOnePress = (scene: Scene, run: Candidate): OnePressCount =>
  countOnePress(scene, ANY, run.tick + 1, maxTicksOf(scene.terms), STRIDE);

/**
 * Plays random games.
 * @param count how many
 * @param most the games end when so many have reached the black hole
 * @returns the games that reached it, as holds, and the ticks simulated
 */
export function luckyGames(
  scene: Scene,
  count: number,
  random: Random,
  most = count,
): { readonly games: readonly (readonly Hold[])[]; readonly ticks: number } {
  const simulation = createSimulation(scene);
  const games: (readonly Hold[])[] = [];
  let ticks = 0;
  for (let game = 0; game < count && games.length < most; game++) {
    const holds = playGameAtRandom(simulation, random, maxTicksOf(scene.terms));
    ticks += simulation.tick;
    if (simulation.ending?.outcome === 'completed') games.push(holds);
  }
  return { games, ticks };
}

/** A few paths on which random play reached the black hole. */
export const luckyWays = (scene: Scene, most: number, random: Random): Way[] =>
  luckyGames(scene, GAMES, random, most).games.map((holds) => wayOf(scene, holds));
