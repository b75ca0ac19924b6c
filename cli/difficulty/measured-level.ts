import type { Accuracy } from '../../engine/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import type { Difficulty, Goal, Success } from '../../solver/index.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** The measured difficulty of one level file. */
export interface MeasuredLevel {
  readonly file: string;
  /** The name of the level, or of the file if it is not a valid level. */
  readonly name: string;
  /** The name of the measured run; null: a search found it. */
  readonly runName: string | null;
  readonly difficulty: Difficulty | null;
  /** Success at more noises; empty unless requested. */
  readonly curve: readonly Success[];
  /** Why there is no difficulty; empty if there is one. */
  readonly why: string;
  /** The problems of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** 0: measured; 1: there is nothing to measure; 2: the file could not be read */
  readonly code: 0 | 1 | 2;
}

/** What to measure, and how. */
export interface MeasureSettings {
  /** The folder's rules. */
  readonly rules: OwnRules;
  readonly accuracy: Accuracy;
  readonly goal: Goal;
  /** The name of the run to measure; null: the first that meets the goal. */
  readonly run: string | null;
  /** Whether to measure the most robust run that a search finds, even if the level has runs. */
  readonly search: boolean;
  /** The effort to find a run, ticks. */
  readonly effort: number;
  readonly seed: number;
  /** s */
  readonly maxTime: number;
  /** Whether to do the slowest parts, too: the cost of minerals, ways round each asteroid, and single holds at every tick. */
  readonly inFull: boolean;
  /** Whether to measure success at more noises, for a picture. */
  readonly withCurve: boolean;
}

/** A task for a worker. */
export interface MeasureTask {
  readonly file: string;
  readonly settings: MeasureSettings;
}
