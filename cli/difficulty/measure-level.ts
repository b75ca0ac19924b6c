import { proveGoalImpossible } from '../../check/index.ts';
import { collectStatistics, compareWithModel } from '../../check/plays/index.ts';
import { effortInWords } from '../../check/words/index.ts';
import { compile, type Scene, TICK_RATE } from '../../engine/index.ts';
import { type Level, readLevel } from '../../schema/index.ts';
import { createSolver, measureDifficulty, type Success, successProbability, verifyRun } from '../../solver/index.ts';
import { showProblems } from '../code-frames.ts';
import { Failure } from '../failure.ts';
import { readBytes } from '../read-bytes.ts';
import { closestRunInWords } from '../report-parts/index.ts';
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
    if (error instanceof Failure) return unreadable(file, error);
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
  const read = readLevel(bytes, settings);
  if (!read.ok) {
    return { ...nothingOf(file), why: 'not a valid level', problems: showProblems(read.problems, read.text), code: 1 };
  }
  const measured = measure(read.level, settings);
  const players = plays === null ? null : playersOf(read.level, measured, plays, settings);
  return { ...nothingOf(file), name: read.level.name, ...measured, players };
}

function playersOf(
  level: Level,
  { runName, difficulty }: Measured,
  { replayed, by, names }: LevelPlays,
  { accuracy, goal, seed, maxTime }: MeasureSettings,
): Players {
  if (difficulty === null) return { statistics: collectStatistics(level, replayed, { goal, by }), model: null, names };
  const { holds } = difficulty.run;
  const statistics = collectStatistics(level, replayed, { goal, by, reference: { holds, name: runName } });
  if (statistics.attempts === 0) return { statistics, model: null, names };
  const maxTicks = Math.round(maxTime * TICK_RATE);
  return { statistics, model: compareWithModel(compile(level, accuracy), holds, statistics, goal, { seed, maxTicks }), names };
}

/**
 * Measures a level again. A search is not repeated: its run is taken from what was measured before.
 * @param before what is claimed of it, not known to be true
 */
export function measureAgain(before: MeasuredLevel, bytes: Uint8Array, settings: MeasureSettings): MeasuredLevel {
  const { file, runName, difficulty } = before;
  const isFound = runName === null && difficulty !== null;
  return measureContent(file, bytes, isFound ? { ...settings, found: difficulty.run.holds } : settings);
}

type Measured = Pick<MeasuredLevel, 'runName' | 'difficulty' | 'curve' | 'why' | 'code'>;

const failed = (why: string): Measured => ({ runName: null, difficulty: null, curve: [], why, code: 1 });

function measure(level: Level, settings: MeasureSettings): Measured {
  const { accuracy, goal, effort, seed, inFull } = settings;
  if (typeof goal.minerals === 'number' && goal.minerals > level.minerals.length) {
    return failed(`it has only ${level.minerals.length} of the ${goal.minerals} minerals required`);
  }
  const scene = compile(level, accuracy);
  const maxTicks = Math.round(settings.maxTime * TICK_RATE);
  const chosen = chooseRun(scene, settings, maxTicks);
  if ('why' in chosen) return failed(chosen.why);
  const difficulty = measureDifficulty(scene, chosen.holds, {
    goal,
    seed,
    maxTicks,
    effort: inFull ? effort : 0,
    asteroidEffort: inFull ? undefined : 0,
    onePressStride: inFull ? 1 : ONE_PRESS_STRIDE,
  });
  if (difficulty === null) throw new Error(`a run that meets the goal could not be measured: ${JSON.stringify(chosen.holds)}`);
  const curve = settings.withCurve ? curveOf(scene, difficulty.run.holds, settings) : [];
  return { runName: chosen.name, difficulty, curve, why: '', code: 0 };
}

type Chosen = { readonly name: string | null; readonly holds: readonly (readonly [number, number])[] } | { readonly why: string };

/** The run to measure: the selected one, else the level's first run that meets the goal, else one that a search finds. */
function chooseRun(scene: Scene, settings: MeasureSettings, maxTicks: number): Chosen {
  const { goal, run, search, effort, seed, accuracy, found } = settings;
  const { level } = scene;
  if (run !== null) {
    const named = level.runs.find(({ name }) => name === run);
    if (named === undefined) return { why: `it has no run named ${JSON.stringify(run)}` };
    if (verifyRun(scene, named.holds, goal, maxTicks) === null) return { why: `run ${JSON.stringify(run)} does not complete it` };
    return named;
  }
  const scripted = search ? undefined : level.runs.find(({ holds }) => verifyRun(scene, holds, goal, maxTicks) !== null);
  if (scripted !== undefined) return scripted;
  if (found !== undefined) {
    return verifyRun(scene, found, goal, maxTicks) === null
      ? { why: 'its run does not complete it' }
      : { name: null, holds: found };
  }
  const proof = proveGoalImpossible(level, accuracy, goal, maxTicks);
  if (proof !== null) return { why: `proved impossible: ${proof.reason}` };
  const known = level.runs.map(({ holds }) => holds);
  const solver = createSolver(scene, { goal, seed, maxTicks, objective: 'robust', known });
  solver.advance(effort);
  if (solver.best !== null) return { name: null, holds: solver.best.holds };
  const near = solver.closest === null ? '' : `, closest approach ${closestRunInWords(solver.closest)}`;
  return { why: `no run was found after simulating ${effortInWords(solver.effort)}${near}` };
}

function curveOf(scene: Scene, holds: readonly (readonly [number, number])[], { goal, seed }: MeasureSettings): Success[] {
  const certain: Success = { sigma: 0, p: 1, low: 1, high: 1, samples: 1 };
  const noisy = SIGMAS.map((sigma) => successProbability(scene, holds, goal, sigma, { samples: CURVE_SAMPLES, seed }));
  return [certain, ...noisy];
}
