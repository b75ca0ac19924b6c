import { existsSync, realpathSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import process from 'node:process';
import { termsReport } from '../../check/words/index.ts';
import {
  findWarnings,
  type Run,
  type Scene,
  STATE_SIZE,
  simulate,
  type Terms,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import {
  formatLevel,
  type Hold,
  type Level,
  type LevelDocument,
  type LevelFile,
  type Problem,
  type RunReport,
  readLevel,
} from '../../schema/index.ts';
import { createDecider, type Decider, type Objective } from '../../solver/index.ts';
import type { CommandResult } from '../command.ts';
import { isPackFile, NOT_A_LEVEL, readBytes, readRegularFile, replaceFile, whyNotWritable } from '../io/index.ts';
import type { Limits } from '../options/index.ts';
import { type ShownProblem, showFileProblems, showProblems } from '../report-parts/index.ts';
import { colorsFor, Failure, notice, systemReason, visibleLine } from '../terminal/index.ts';

export interface OpenedLevel {
  readonly level: Level;
  readonly document: LevelDocument;
}

/** A level with the bytes of its file, to notice later changes of the file. */
export interface OpenedFile extends OpenedLevel {
  readonly bytes: Uint8Array;
}

/**
 * Reads the level that a command works on.
 * @param terms the rules of the folder apply where the level has none of its own
 * @returns the level, or the result of the command if the file is not a valid level
 * @throws Failure if the file can't be read
 */
export function openLevel(file: string, { rules }: Pick<Terms, 'rules'>): OpenedFile | CommandResult {
  if (isPackFile(file)) throw new Failure(`${file}: ${NOT_A_LEVEL}`);
  const bytes = readBytes(file);
  const read = readLevel(bytes, { rules });
  if (read.ok) {
    const { length } = read.document.file.conflicts ?? [];
    if (length > 0) {
      const open = `${length === 1 ? 'a conflict' : `${length} conflicts`} of a merge`;
      notice(`warning: ${visibleLine(file)} has ${open}: gq used our values; gq check lists them, gq edit decides them\n`);
    }
    return { level: read.level, document: read.document, bytes };
  }
  return { messages: showFileProblems(file, showProblems(read.problems, read.text), colorsFor(process.stderr)), exitCode: 1 };
}

/** The warnings about a valid level and its simulated runs, with places. */
export function warningsOf({ level, document }: OpenedLevel, runs: readonly Run[], terms: Terms): ShownProblem[] {
  const warnings = findWarnings(level, runs, terms);
  return warnings.length === 0
    ? []
    : showProblems(
        warnings.map((w) => placed(w, document)),
        document.text,
      );
}

/** Adds the line and column of a problem's JSON pointer. */
export function placed(problem: Omit<Problem, 'line' | 'column'>, document: LevelDocument): Problem {
  if (problem.pointer === '') return { ...problem, line: null, column: null };
  return { ...problem, ...document.locate(problem.pointer) };
}

/**
 * Writes a level file in the canonical layout, in place of the one that was read before a search.
 * @param base the bytes that were read
 * @param file the new content
 * @param remedy what to do if the file has changed since
 * @throws Failure if the file has changed since, or can't be written
 */
export function replaceLevel(path: string, base: Uint8Array, file: LevelFile, remedy: string): void {
  const content = Buffer.from(formatLevel(file));
  try {
    // a link stays a link: the file that it leads to is replaced
    const real = realpathSync(path);
    replaceFile(real, content, () => {
      if (Buffer.compare(readBytes(real), base) === 0) return;
      throw new Failure(`${path}: the file changed during the search, so nothing was written: ${remedy}`);
    });
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

/** Checks before a long search whether its result can be written. @throws Failure if it can't */
export function expectWritable(path: string): void {
  const why = whyNotWritable(path);
  if (why !== null) throw new Failure(`${path}: --write can't write it: ${why}`);
}

const TOOLKIT = 'gravity-quest-toolkit';

/** bytes */
const LARGEST_MANIFEST = 1024 * 1024;

/**
 * The value of `$schema` for a file in `directory`: the path, with slashes, to the JSON Schema of the toolkit that the
 * surrounding project has installed, or that is the project itself. null if there is none: a path that leads out of the project
 * would work on this machine only.
 * @param content what the file has
 */
export function schemaReference(directory: string, content: 'level' | 'pack' = 'level'): string | null {
  const from = resolve(directory);
  for (let at = from; ; at = dirname(at)) {
    const installed = join(at, 'node_modules', TOOLKIT);
    const home = existsSync(installed) ? installed : isToolkit(at) ? at : null;
    if (home !== null)
      return relative(from, join(home, 'schema', `${content}.schema.json`))
        .split(sep)
        .join('/');
    if (dirname(at) === at) return null;
  }
}

function isToolkit(directory: string): boolean {
  try {
    return (
      JSON.parse(Buffer.from(readRegularFile(join(directory, 'package.json'), LARGEST_MANIFEST)).toString()).name === TOOLKIT
    );
  } catch {
    // no such file, or not JSON: that does not concern this project
    return false;
  }
}

/**
 * A run as in the output of `gq simulate --format json`.
 * @param sampleRate samples per second, at k / sampleRate s from the start to the end of the run; null for none
 */
export function reportRun(scene: Scene, holds: readonly Hold[], run: Run, sampleRate: number | null): RunReport {
  const { x, y, vx, vy, cos, sin } = run.final;
  return {
    level: scene.level.name,
    accuracy: scene.accuracy.name,
    terms: termsReport(scene),
    holds: holds.map(([press, release]) => [press, release]),
    outcome: run.outcome,
    with: run.with,
    time: run.time,
    tick: run.tick,
    minerals: [...run.minerals],
    events: [...run.events],
    clearance: run.clearance,
    // the engine uses directions, not angles: an angle is for people, and its last bit may differ between processors
    final: { x, y, vx, vy, angle: Math.atan2(sin, cos) },
    samples: sampleRate === null ? [] : sample(run, sampleRate),
    hash: run.hash,
  };
}

function sample(run: Run, rate: number): RunReport['samples'] {
  const state = new Float64Array(STATE_SIZE);
  const samples: RunReport['samples'] = [];
  for (let k = 0; k / rate <= run.trajectory.duration; k++) {
    run.trajectory.at(k / rate, state);
    samples.push([k / rate, state[0], state[1], state[2], state[3], Math.atan2(state[5], state[4])]);
  }
  return samples;
}

/**
 * Plays a run, and reads of it what is needed, within the work that the level may cost.
 * @param scene the compiled level
 * @param read reads of the played run
 * @throws Failure if that costs more
 */
export function withinWorkOf<T>(scene: Scene, holds: readonly Hold[], read: (run: Run) => T): T {
  const budget = new WorkBudget(scene.terms.maxWork);
  const run = simulate(scene, holds, { budget });
  return orTooMuch(scene.terms, () => (run.stopped === null ? read(run) : budget.end()));
}

/** Does something with a run. @throws Failure if it takes more work than the terms allow */
export function orTooMuch<T>({ maxWork }: Pick<Terms, 'maxWork'>, work: () => T): T {
  try {
    return work();
  } catch (error) {
    if (!(error instanceof WorkLimitReached)) throw error;
  }
  throw new Failure(
    `the run costs more work than allowed, ${maxWork} pieces of motion: allow more with --max-work, or end it earlier with --max-time`,
  );
}

/** Simulated ticks between two looks at the clock. */
const SLICE = 50_000;

/**
 * Searches for a run that completes a level, and as long as there is none, for a proof that there is none. Blocks the calling thread
 * for as long as the limits allow.
 */
export function decideWithin(scene: Scene, { budget, effort }: Limits, seed: number, objective: Objective): Decider {
  const end = budget === null ? Number.POSITIVE_INFINITY : performance.now() + 1000 * budget;
  const isStopped = (): boolean => performance.now() >= end;
  const decider = createDecider(scene, { objective, seed, effort: effort ?? undefined, isStopped });
  while (!decider.finished && !isStopped()) decider.advance(SLICE);
  return decider;
}
