import { jumpsOf } from '../../check/pack/index.ts';
import type { FittedPlayers, ModelComparison, PlayStatistics } from '../../check/plays/index.ts';
import { termsReport } from '../../check/words/index.ts';
import type { Terms } from '../../engine/index.ts';
import { type Hold, levelsOfPack, type TermsReport } from '../../schema/index.ts';
import type { Difficulty, Goal, Success } from '../../solver/index.ts';
import type { ConfiguredTerms } from '../config/index.ts';
import { type FoundPack, levelIdOf, nameOfFile, runInPool } from '../io/index.ts';
import { type TermsOptions, termsFrom } from '../options/index.ts';
import { readPackFile } from '../pack-file/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';
import { type Failure, visibleLine } from '../terminal/index.ts';
import type { LevelPlays } from './plays/index.ts';

/** The measured difficulty of one level file. */
export interface MeasuredLevel {
  readonly file: string;
  /** The name of the level, or of the file if it is not a valid level. */
  readonly name: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  /** The name of the measured run; null: a search found it. */
  readonly runName: string | null;
  readonly difficulty: Difficulty | null;
  /** The name of each run that was compared; null: a search found it. */
  readonly comparedNames: readonly (string | null)[];
  /** Success at more noises; empty unless requested. */
  readonly curve: readonly Success[];
  /** What players teach; null unless plays are given, or if it is not a valid level. */
  readonly players: Players | null;
  /** Why there is no difficulty; empty if there is one. */
  readonly why: string;
  /** The problems of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** 0: measured; 1: there is nothing to measure; 2: the file could not be read */
  readonly code: 0 | 1 | 2;
}

/** Nothing is measured yet. */
export const nothingOf = (file: string, terms: Terms) =>
  ({
    file,
    name: nameOfFile(file),
    terms: termsReport({ terms, level: terms }),
    runName: null,
    difficulty: null,
    comparedNames: [],
    curve: [],
    players: null,
    problems: [],
  }) as const;

/** A file that can't be read. */
export const unreadable = (file: string, { message }: Failure, terms: Terms): MeasuredLevel => ({
  ...nothingOf(file, terms),
  why: message,
  code: 2,
});

/** What players teach about a level, beside what the model says. */
export interface Players {
  readonly statistics: PlayStatistics;
  /** How the model of timing noise compares; null without a run to compare with, or without attempts. */
  readonly model: ModelComparison | null;
  /** Success of the run that they are compared with, under timing noise of 40 ms; null where there is no model. */
  readonly p40: number | null;
  /** The player model fitted to them; null where nothing can be fitted. */
  readonly fit: FittedPlayers | null;
  /** What to call each play. */
  readonly names: readonly string[];
}

/** What to measure, and how. */
export interface MeasureSettings {
  readonly terms: Terms;
  readonly goal: Goal;
  /** The name of the run to measure; null: the one that forgives most, of its own and those that a search finds. */
  readonly run: string | null;
  /** The runs that were compared before: there is no other search. */
  readonly found?: readonly (readonly Hold[])[];
  /** The effort to find runs, ticks. */
  readonly effort: number;
  readonly seed: number;
  /** Whether to do the slowest parts, too: the cost of minerals, ways round each asteroid, and single holds at every tick. */
  readonly inFull: boolean;
  /** Whether to measure success at more noises, for a picture. */
  readonly withCurve: boolean;
}

/** A task for a worker. */
export interface MeasureTask {
  readonly file: string;
  readonly settings: MeasureSettings;
  /** Plays of the level; null unless plays are given. */
  readonly plays: LevelPlays | null;
}

/** The options that say what to measure. */
interface MeasureOptions extends TermsOptions {
  readonly run?: string;
  readonly minerals: Goal['minerals'];
  readonly effort: number;
  readonly seed: number;
}

/** What the options and the configuration choose for a level of many. */
export function measureSettings(options: MeasureOptions, configuration: ConfiguredTerms): MeasureSettings {
  const { run = null, minerals, effort, seed } = options;
  const terms = termsFrom(options, configuration);
  return { terms, goal: { minerals }, run, effort, seed, inFull: false, withCurve: false };
}

/**
 * Measures the difficulty of level files in worker threads.
 * @param plays the plays of each file; null unless plays are given
 * @param jobs the largest number of threads
 * @param onProgress called after each file with the number of files that are done
 * @returns one report for each file, in the same order
 */
export function measureLevels(
  files: readonly string[],
  settings: MeasureSettings,
  plays: ReadonlyMap<string, LevelPlays> | null,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<MeasuredLevel[]> {
  const tasks = files.map((file): MeasureTask => ({ file, settings, plays: plays?.get(file) ?? null }));
  return runInPool<MeasureTask, MeasuredLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onProgress);
}

/** The curve of difficulty of a pack. */
export interface PackCurve {
  readonly file: string;
  readonly name: string;
  /** The files of the listed levels, in the order in which they are played. */
  readonly levels: readonly string[];
  /** The grade of each; null where none was measured. */
  readonly grades: readonly (number | null)[];
  /** Levels that are much harder than all before them. */
  readonly jumps: readonly { readonly file: string; readonly after: string; readonly by: number }[];
}

/** The curve of each pack that is valid. @param levels in the order of the packs */
export function curvesOf(packs: readonly FoundPack[], levels: readonly MeasuredLevel[]): PackCurve[] {
  return packs.flatMap(({ file, folder, levels: files }) => {
    const read = readPackFile(file);
    if ('unreadable' in read || !read.reading.ok) return [];
    const { pack } = read.reading;
    const listed = new Set(levelsOfPack(pack));
    const below = new Set(files);
    const inIt = levels.filter((level) => below.has(level.file) && listed.has(levelIdOf(folder, level.file)));
    const grades = inIt.map(({ difficulty }) => difficulty?.grade.value ?? null);
    const jumps = jumpsOf(grades).map(({ index, from, by }) => ({ file: inIt[index].file, after: inIt[from].file, by }));
    return [{ file, name: pack.name, levels: inIt.map((level) => level.file), grades, jumps }];
  });
}

/** The curves for people: the grades in order, and what jumps. */
export function curvesInWords(curves: readonly PackCurve[]): string {
  return curves
    .map(({ file, grades, jumps }) => {
      const list = grades.map((grade) => grade?.toFixed(1) ?? '-').join(' ');
      const lines = jumps.map(
        (jump) =>
          `  a jump: ${visibleLine(jump.file)} is ${jump.by.toFixed(1)} above the hardest level before it, ${visibleLine(jump.after)}\n`,
      );
      return `in the order of ${visibleLine(file)}: ${list}\n${lines.join('')}`;
    })
    .join('');
}
