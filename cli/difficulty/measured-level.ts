import type { FittedPlayers, ModelComparison, PlayStatistics } from '../../check/plays/index.ts';
import { termsReport } from '../../check/words/index.ts';
import type { Terms } from '../../engine/index.ts';
import type { Hold, TermsReport } from '../../schema/index.ts';
import type { Difficulty, Goal, Success } from '../../solver/index.ts';
import { type Failure, nameOfFile } from '../io/index.ts';
import type { ShownProblem } from '../shown-problem.ts';
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
