import { proveGoalImpossible } from '../../check/index.ts';
import { collectStatistics, compareWithModel, fitToPlays, type Reference } from '../../check/plays/index.ts';
import { effortInWords, termsReport } from '../../check/words/index.ts';
import { compile, joinHolds, maxTicksOf, type Scene } from '../../engine/index.ts';
import { type Hold, type Level, readLevel } from '../../schema/index.ts';
import { findRuns, measureDifficulty, type Success, successProbability, verifyRun } from '../../solver/index.ts';
import { readBytes } from '../io/index.ts';
import { closestRunInWords, showProblems } from '../report-parts/index.ts';
import { Failure } from '../terminal/index.ts';
import {
  type MeasuredLevel,
  type MeasureSettings,
  type MeasureTask,
  nothingOf,
  type Players,
  unreadable,
} from './measured-level.ts';
import type { LevelPlays } from './plays/index.ts';

/** ms; the noises at which a curve is sampled. Success at 0 is certain. */
const SIGMAS = [10, 20, 30, 40, 50, 60, 80, 100, 130, 160, 200, 250, 300] as const;

const CURVE_SAMPLES = 1000;

/** With several levels, single holds are tried at every fourth tick only: a sixteenth of all pairs of press and release. */
const ONE_PRESS_STRIDE = 4;

/** Measures the difficulty of one level file. Throws only if gq itself fails. */
export function measureLevel({ file, settings, plays }: MeasureTask): MeasuredLevel {
  let bytes: Uint8Array;
  try {
    bytes = readBytes(file);
  } catch (error) {
    if (error instanceof Failure) return unreadable(file, error, settings.terms);
    throw error;
  }
  return measureContent(file, bytes, settings, plays);
}

/** Measures the difficulty of a level. @param file its file, or where else it is from */
export function measureContent(
  file: string,
  bytes: Uint8Array,
  settings: MeasureSettings,
  plays: LevelPlays | null = null,
): MeasuredLevel {
  const { terms } = settings;
  const read = readLevel(bytes, terms);
  if (!read.ok) {
    return { ...nothingOf(file, terms), why: 'not a valid level', problems: showProblems(read.problems, read.text), code: 1 };
  }
  const measured = measure(read.level, settings);
  const players = plays === null ? null : playersOf(read.level, measured, plays, settings);
  const { level } = read;
  return { ...nothingOf(file, terms), name: level.name, terms: termsReport({ terms, level }), ...measured, players };
}

function playersOf(
  level: Level,
  { runName, difficulty }: Measured,
  { replayed, by, names }: LevelPlays,
  { terms, goal, seed, run }: MeasureSettings,
): Players {
  const measured = difficulty === null ? null : { holds: difficulty.run.holds, name: runName };
  const collect = (reference?: Reference) => collectStatistics(level, terms, replayed, { by, reference });
  // the run that players take is mostly one of the level's own; the one that forgives most may be another way
  const own = collect(run === null || measured === null ? undefined : measured);
  const statistics = own.reference === null && measured !== null ? collect(measured) : own;
  const { reference, attempts } = statistics;
  if (reference === null || attempts === 0) return { statistics, model: null, p40: null, fit: null, names };
  const scene = compile(level, terms);
  const options = { seed, maxTicks: maxTicksOf(terms) };
  return {
    statistics,
    model: compareWithModel(scene, reference.holds, statistics, goal, options),
    p40: successProbability(scene, reference.holds, goal, 40, options).p,
    fit: fitToPlays(scene, reference.holds, statistics, by, goal, options),
    names,
  };
}

/**
 * Measures a level again. A search is not repeated: its runs are taken from what was measured before.
 * @param before what is claimed of it, not known to be true
 */
export function measureAgain(before: MeasuredLevel, bytes: Uint8Array, settings: MeasureSettings): MeasuredLevel {
  const { file, difficulty } = before;
  if (settings.run !== null || difficulty === null) return measureContent(file, bytes, settings);
  return measureContent(file, bytes, { ...settings, found: difficulty.comparison.runs.map(({ run }) => run.holds) });
}

type Measured = Pick<MeasuredLevel, 'runName' | 'difficulty' | 'comparedNames' | 'curve' | 'why' | 'code'>;

const failed = (why: string): Measured => ({ runName: null, difficulty: null, comparedNames: [], curve: [], why, code: 1 });

function measure(level: Level, settings: MeasureSettings): Measured {
  const { terms, goal, effort, seed, inFull } = settings;
  if (typeof goal.minerals === 'number' && goal.minerals > level.minerals.length) {
    return failed(`it has only ${level.minerals.length} of the ${goal.minerals} minerals required`);
  }
  const scene = compile(level, terms);
  const chosen = chooseRuns(scene, settings);
  if ('why' in chosen) return failed(chosen.why);
  const difficulty = measureDifficulty(scene, null, {
    goal,
    seed,
    runs: chosen.runs,
    effort: inFull ? effort : 0,
    asteroidEffort: inFull ? undefined : 0,
    onePressStride: inFull ? 1 : ONE_PRESS_STRIDE,
  });
  if (difficulty === null) throw new Error(`runs that meet the goal could not be measured: ${JSON.stringify(chosen.runs)}`);
  const curve = settings.withCurve ? curveOf(scene, difficulty.run.holds, settings) : [];
  const comparedNames = difficulty.comparison.runs.map(({ run: { holds } }) => nameOf(level, holds));
  return { runName: comparedNames[0], difficulty, comparedNames, curve, why: '', code: 0 };
}

/** The name of the level's run with these holds; null if it has none. */
function nameOf(level: Level, holds: readonly Hold[]): string | null {
  const last = holds[holds.length - 1]?.[1] ?? 0;
  const text = JSON.stringify(holds);
  // what a run does after its end was left out
  const same = level.runs.find((run) => JSON.stringify(joinHolds(run.holds).filter(([press]) => press <= last)) === text);
  return same?.name ?? null;
}

type Chosen = { readonly runs: readonly (readonly Hold[])[] } | { readonly why: string };

/** The runs to compare: the selected one alone, or the level's own that meet the goal and those that a search finds. */
function chooseRuns(scene: Scene, settings: MeasureSettings): Chosen {
  const { goal, run, effort, seed, found } = settings;
  const { level } = scene;
  const isGood = (holds: readonly Hold[]): boolean => verifyRun(scene, holds, goal) !== null;
  if (run !== null) {
    const named = level.runs.find(({ name }) => name === run);
    if (named === undefined) return { why: `it has no run named ${JSON.stringify(run)}` };
    return isGood(named.holds) ? { runs: [named.holds] } : { why: `run ${JSON.stringify(run)} does not complete it` };
  }
  if (found !== undefined) return found.some(isGood) ? { runs: found } : { why: 'its run does not complete it' };
  if (!level.runs.some(({ holds }) => isGood(holds))) {
    const proof = proveGoalImpossible(scene, goal);
    if (proof !== null) return { why: `proved impossible: ${proof.reason}` };
  }
  const search = findRuns(scene, goal, { effort, seed, maxTicks: maxTicksOf(scene.terms) });
  if (search.runs.length > 0) return search;
  const near = search.closest === null ? '' : `, closest approach ${closestRunInWords(search.closest)}`;
  return { why: `no run was found after simulating ${effortInWords(search.effort)}${near}` };
}

function curveOf(scene: Scene, holds: readonly Hold[], { goal, seed }: MeasureSettings): Success[] {
  const certain: Success = { sigma: 0, p: 1, low: 1, high: 1, samples: 1 };
  const noisy = SIGMAS.map((sigma) => successProbability(scene, holds, goal, sigma, { samples: CURVE_SAMPLES, seed }));
  return [certain, ...noisy];
}
