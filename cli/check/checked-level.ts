import type { Accuracy } from '../../engine/index.ts';
import type { RunReport, Verdict } from '../../schema/index.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** What `check` found out about one level file. */
export interface CheckedLevel {
  readonly file: string;
  /** The level's name; the file's where it is not a valid level. */
  readonly name: string;
  readonly verdict: Verdict;
  /** The first run that completes the level, else its first run. */
  readonly run: RunReport | null;
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
}
