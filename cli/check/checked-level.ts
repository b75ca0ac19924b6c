import type { Terms } from '../../engine/index.ts';
import type { Allowed, Hold, RunReport, SoftlockReport, TermsReport, Verdict } from '../../schema/index.ts';
import type { Limits } from '../search-options.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** A run in brief: what a line about it, and a place in it, need. */
export interface RunInBrief extends Pick<RunReport, 'outcome' | 'time' | 'tick' | 'minerals' | 'clearance'> {
  /** Its name in the file; null if a search found it. */
  readonly name: string | null;
  /** Covers its motion bit for bit. Only with `forLock`; null if it would cost too much work. */
  readonly hash?: string | null;
  /** Its certified ticks, as a lock counts them. Only with `forLock`; null if it does not complete the level or costs too much work. */
  readonly certifiedTicks?: number | null;
  /** Where it stands in the file. Only with `forLock`; null if a search found it. */
  readonly place?: Pick<ShownProblem, 'pointer' | 'line' | 'column' | 'frame'> | null;
}

/** The results of `check` for one level file. */
export interface CheckedLevel {
  readonly file: string;
  /** The name of the level, or of the file if it is not a valid level. */
  readonly name: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  readonly verdict: Verdict;
  /** The first run that completes the level, its own or one found by a search; else its first run. */
  readonly run: RunInBrief | null;
  /** The holds of that run if a search found it; else null. */
  readonly found: readonly Hold[] | null;
  /** The same run in full; null if the settings don't ask for it. */
  readonly report: RunReport | null;
  /** The number of minerals in the level. */
  readonly mineralCount: number;
  /** The problems that the level allows, by code; missing if it allows none. */
  readonly allow?: Allowed;
  /** How many problems were left out because it allows them. */
  readonly allowed?: number;
  /** Where it is already lost although she lives on. Only with `softlocks`; null if no run completes the level. */
  readonly softlocks?: SoftlockReport | null;
  readonly problems: readonly ShownProblem[];
  /** Whether the file itself could not be read. */
  readonly unreadable: boolean;
  /** ms of wall time for reading and replaying */
  readonly ms: number;
}

/** How to check a level. */
export interface CheckSettings {
  readonly terms: Terms;
  /** Whether runs are reported in full; the hash covers every sample and takes an eighth of the time of a check. */
  readonly inFull: boolean;
  /** Whether to find out what a lock compares: hash and certified ticks. Off by default, as it takes longer than the rest. */
  readonly forLock?: boolean;
  /** Whether to try to prove that minerals which no run collects can't be collected: takes up to 0.1 s for each level. */
  readonly proveMinerals: boolean;
  /** How to search if no run of the level completes it; null: not at all. */
  readonly search: SearchSettings | null;
  /** Ticks by which every press and release of each completing run must be allowed to move; null: no requirement. */
  readonly requireSlack: number | null;
  /** Ticks that the search for places where the level is already lost may take; absent: there is none. */
  readonly softlocks?: number;
}

/** How to search a level that none of its runs completes. */
export interface SearchSettings {
  /** The limits for each level. */
  readonly limits: Limits;
  readonly seed: number;
  /** The run that the search is said to have found: it is played, and nothing is searched. */
  readonly claimed?: readonly Hold[];
}
