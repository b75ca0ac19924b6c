import type { Accuracy } from '../../engine/index.ts';
import type { RunReport, Verdict } from '../../schema/index.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** What a line about a run says. */
export type RunInBrief = Pick<RunReport, 'time' | 'minerals' | 'clearance'>;

/** What `check` found out about one level file. */
export interface CheckedLevel {
  readonly file: string;
  /** The level's name; the file's where it is not a valid level. */
  readonly name: string;
  readonly verdict: Verdict;
  /** The first run that completes the level, else its first run. */
  readonly run: RunInBrief | null;
  /** The same run in full; null where the settings don't ask for it. */
  readonly report: RunReport | null;
  /** How many minerals the level has. */
  readonly mineralCount: number;
  readonly problems: readonly ShownProblem[];
  /** The file itself could not be read. */
  readonly unreadable: boolean;
  /** How long reading and replaying took, ms of wall time. */
  readonly ms: number;
}

/** How a level is to be checked. */
export interface CheckSettings {
  readonly accuracy: Accuracy;
  /** s of simulated time after which a run is a timeout */
  readonly maxTime: number;
  /** Whether runs are reported in full: the hash, which covers every sample, takes an eighth of the time of a check. */
  readonly inFull: boolean;
}
