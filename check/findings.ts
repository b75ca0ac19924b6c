import type { Warning, WorkBudget } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import type { Closest, Effort, Proof } from '../solver/index.ts';
import type { AccuracyHang } from './accuracy-hangs.ts';
import type { LostMineral } from './proofs.ts';
import type { TightRun } from './tight-runs.ts';
import { type LevelVerdict, verdictOf } from './verdict.ts';
import type { RunEnd } from './words/index.ts';

/** How one of the level's own runs ended. */
export interface ScriptEnd extends RunEnd {
  readonly name: string;
  /** It cost more than allowed, and was not played beyond `time`. */
  readonly isStopped: boolean;
}

/** How much was allowed where that did not suffice. */
export interface Overrun {
  /** pieces of motion */
  readonly maxWork: number;
  /** What there was too much of. */
  readonly of: 'work' | 'memory';
}

/** How a budget that did not suffice was overrun. */
export const overrunOf = ({ maxWork, spent }: Pick<WorkBudget, 'maxWork' | 'spent'>): Overrun => ({
  maxWork,
  of: spent >= maxWork ? 'work' : 'memory',
});

/** What playing a level's runs shows, and what looks wrong in it. Plain data: a worker can send it. */
export interface RunFindings {
  /** Name of the setting at which runs were played. */
  readonly accuracy: string;
  /** px, of the level */
  readonly range: number;
  /** In the order of the level's list. */
  readonly ends: readonly ScriptEnd[];
  /** Indices of the minerals that some run collects. */
  readonly collected: readonly number[];
  readonly hangs: readonly AccuracyHang[];
  /** In the order in which `findWarnings` gives them. */
  readonly warnings: readonly Warning[];
  /** What was left out since it would have cost more than allowed; null: nothing was. */
  readonly cuts: {
    /** Runs were not played to their end. */
    readonly runs: Overrun | null;
    /** It was not looked at whether they end alike at every accuracy. */
    readonly accuracies: Overrun | null;
    /** It was not looked at what they come near to. */
    readonly nearness: Overrun | null;
  };
}

/** What a search for a run came to. */
export interface Searched {
  /** A run that completes the level, replayed from the start; null: none was found. */
  readonly found: readonly Hold[] | null;
  readonly effort: Effort;
  /** null: nothing was tried */
  readonly closest: Closest | null;
}

/** What was found out besides. */
export interface MoreFindings {
  /** Proof that nobody can complete the level; null: there is none. */
  readonly impossible: Proof | null;
  /** Minerals of which it is proved that nobody collects them. */
  readonly lost: readonly LostMineral[];
  /** null: no run was looked for */
  readonly searched: Searched | null;
  /** Runs that forgive too little; none where nobody asked. */
  readonly tight: readonly TightRun[];
}

/** All that a check finds out about a level, before it is put into words. */
export interface Findings extends RunFindings, MoreFindings {}

/** Where nothing was proved, searched for or asked about. */
export const unproved: MoreFindings = { impossible: null, lost: [], searched: null, tight: [] };

/** What playing the runs showed, with what was found out besides. */
export const findingsOf = (runs: RunFindings, more: Partial<MoreFindings>): Findings => ({ ...runs, ...unproved, ...more });

/** Whether one of the level's own runs completes it. */
export const completesItself = ({ ends }: Pick<RunFindings, 'ends'>): boolean =>
  ends.some(({ outcome }) => outcome === 'completed');

/** The verdict on a level of which so much is known. */
export function verdictOfFindings(findings: Pick<Findings, 'ends' | 'impossible' | 'searched'>): LevelVerdict {
  const { ends, impossible, searched } = findings;
  return verdictOf({
    isCompleted: completesItself(findings) || (searched !== null && searched.found !== null),
    isImpossible: impossible !== null,
    runs: ends.length,
    areAllPlayed: ends.every(({ isStopped }) => !isStopped),
  });
}
