import type { Terms } from '../../engine/index.ts';
import type { Hold, RuleName, TermsReport } from '../../schema/index.ts';
import { runInPool } from '../io/index.ts';
import type { Limits } from '../options/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';
import type { Change, Sweep } from './rule-options.ts';

/** Which rules to change, and how to find the effects. */
export interface TuneSettings {
  readonly terms: Terms;
  /** Changes that apply together. */
  readonly changes: readonly Change[];
  /** A sweep on top of the changes; null: none. */
  readonly sweep: Sweep | null;
  /** How to search if none of the level's own runs completes it any more; null: not at all. */
  readonly search: { readonly limits: Limits; readonly seed: number } | null;
}

/** A task for a worker. */
export interface TuneTask {
  readonly file: string;
  readonly settings: TuneSettings;
}

/** `kept`: its run still completes the level; `other`: another run does. */
export type TunedState = 'kept' | 'other' | 'unproven' | 'impossible';

/** A level with one choice of rules. */
export interface TunedValue {
  /** The value of the swept rule; null without a sweep. */
  readonly value: number | null;
  readonly state: TunedState;
  /** The holds of the other run. */
  readonly holds: readonly Hold[] | null;
}

/** How far a rule may differ from the level's own value. */
export interface RuleInterval {
  readonly rule: RuleName;
  /** The level's value without the changes. */
  readonly own: number;
  /** The smallest and largest value around its own with which its run completes the level; null if it fails with its own. */
  readonly low: number | null;
  readonly high: number | null;
  /** Whether the run fails beyond this end; false: no value beyond was tried. */
  readonly isLowBound: boolean;
  readonly isHighBound: boolean;
  /** Whether any bit of its run at the smallest or largest tried value differs from that at its own value. */
  readonly matters: boolean;
}

/** The effects of changed rules on one level file. */
export interface TunedLevel {
  readonly file: string;
  readonly name: string;
  /** Under which terms all this holds, without the changes. */
  readonly terms: TermsReport;
  /** The name of the examined run, the first that completes the level; null: none does. */
  readonly run: string | null;
  readonly values: readonly TunedValue[];
  readonly intervals: readonly RuleInterval[];
  /** The smallest share of its own value by which a rule changes before its run fails; null: it never failed. */
  readonly room: number | null;
  /** The problems of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** Why there are no results; empty if there are. */
  readonly why: string;
  /** 0: done; 1: not a valid level; 2: the file can't be read or a value is out of a rule's range */
  readonly code: 0 | 1 | 2;
}

/**
 * Finds the effects of changed rules on level files in worker threads.
 * @param jobs the largest number of threads
 * @param onProgress called after each file with the number of files that are done
 * @returns one entry for each file, sorted by the smallest change that makes its run fail, then in the order of the files
 */
export async function tuneLevels(
  files: readonly string[],
  settings: TuneSettings,
  jobs: number,
  onProgress: (done: number) => void,
): Promise<TunedLevel[]> {
  const tasks = files.map((file): TuneTask => ({ file, settings }));
  const levels = await runInPool<TuneTask, TunedLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onProgress);
  const roomOf = ({ room }: TunedLevel): number => room ?? Number.POSITIVE_INFINITY;
  return levels.sort((a, b) => (roomOf(a) === roomOf(b) ? 0 : roomOf(a) - roomOf(b)));
}
