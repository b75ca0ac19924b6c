import type { Accuracy } from '../../engine/index.ts';
import type { Hold, OwnRules, RuleName } from '../../schema/index.ts';
import type { Limits } from '../search-options.ts';
import type { ShownProblem } from '../shown-problem.ts';
import type { Change, Sweep } from './rule-options.ts';

/** What is changed, and how it is looked at. */
export interface TuneSettings {
  readonly accuracy: Accuracy;
  /** s of simulated time after which a run is a timeout */
  readonly maxTime: number;
  /** Pieces of motion that a replay may cost. */
  readonly maxWork: number;
  /** Rules that the folder sets. */
  readonly rules: OwnRules;
  /** Made together. */
  readonly changes: readonly Change[];
  /** On top of the changes; null: these alone. */
  readonly sweep: Sweep | null;
  /** How to search where no run of the level's own is left; null: not at all. */
  readonly search: { readonly limits: Limits; readonly seed: number } | null;
}

/** One task of a worker. */
export interface TuneTask {
  readonly file: string;
  readonly settings: TuneSettings;
}

/** `kept`: its run completes the level still; `other`: another run does. */
export type TunedState = 'kept' | 'other' | 'unproven' | 'impossible';

/** A level under one choice of rules. */
export interface TunedValue {
  /** Of the swept rule; null without a sweep. */
  readonly value: number | null;
  readonly state: TunedState;
  /** The other run. */
  readonly holds: readonly Hold[] | null;
}

/** How far a rule may go from a level's own value. */
export interface RuleInterval {
  readonly rule: RuleName;
  /** The level's value, without the changes. */
  readonly own: number;
  /** Least and greatest value around its own with which its run completes the level; null where it doesn't with its own. */
  readonly low: number | null;
  readonly high: number | null;
  /** Whether the run fails beyond that end; false: no value was tried beyond. */
  readonly isLowBound: boolean;
  readonly isHighBound: boolean;
  /** Whether its run is another, in any bit, at an end of what was tried than at its own value. */
  readonly matters: boolean;
}

/** What a change of rules does to one level file. */
export interface TunedLevel {
  readonly file: string;
  readonly name: string;
  /** The run that is looked at: the first that completes the level; null: none does. */
  readonly run: string | null;
  readonly values: readonly TunedValue[];
  readonly intervals: readonly RuleInterval[];
  /** The least share of its own value by which a rule may change before its run fails; null: it never did. */
  readonly room: number | null;
  /** Of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** Why there is nothing to tell; empty when there is. */
  readonly why: string;
  /** 0 looked at, 1 not a valid level, 2 it can't be read or a value is out of a rule's range */
  readonly code: 0 | 1 | 2;
}
