import type { ShownProblem } from '../problem.ts';
import type { RunJson } from '../run-json.ts';

/** What `check` says of a level, in the order in which a summary counts them. */
export const VERDICTS = ['completable', 'broken', 'unproven', 'impossible', 'invalid', 'crashed'] as const;

export type Verdict = (typeof VERDICTS)[number];

/** What `check` found out about one level file. */
export interface LevelReport {
  readonly file: string;
  /** null where the file is not a valid level */
  readonly name: string | null;
  readonly verdict: Verdict;
  /** The first run that completes the level, else its first run. */
  readonly run: RunJson | null;
  /** The name of that run. */
  readonly runName: string | null;
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
  readonly accuracy: string;
  /** s of simulated time after which a run is a timeout */
  readonly maxTime: number;
}
