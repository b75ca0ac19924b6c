import type { Accuracy } from '../../engine/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import type { Difficulty, Goal, Success } from '../../solver/index.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** How hard one level file was found to be. */
export interface MeasuredLevel {
  readonly file: string;
  /** The level's name; the file's where it is not a valid level. */
  readonly name: string;
  /** The run that was measured is this one of the level's; null: it was found. */
  readonly runName: string | null;
  readonly difficulty: Difficulty | null;
  /** Success at more noises; empty unless asked for. */
  readonly curve: readonly Success[];
  /** Why there is no difficulty; empty when there is one. */
  readonly why: string;
  /** Of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** 0 measured, 1 there is nothing to measure, 2 the file could not be read */
  readonly code: 0 | 1 | 2;
}

/** What is measured, and how. */
export interface MeasureSettings {
  /** Rules that the folder sets. */
  readonly rules: OwnRules;
  readonly accuracy: Accuracy;
  readonly goal: Goal;
  /** The run to measure; null: the first that meets the goal. */
  readonly run: string | null;
  /** Measure the most robust run that a search finds, whatever runs there are. */
  readonly search: boolean;
  /** Ticks simulated to find a run. */
  readonly effort: number;
  readonly seed: number;
  /** s */
  readonly maxTime: number;
  /** What takes longest, too: what minerals cost beyond, ways round each asteroid, and one press at every tick. */
  readonly inFull: boolean;
  /** Success at more noises, for a picture. */
  readonly withCurve: boolean;
}

/** One task of a worker. */
export interface MeasureTask {
  readonly file: string;
  readonly settings: MeasureSettings;
}
