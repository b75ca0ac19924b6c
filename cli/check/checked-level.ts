import type { Accuracy } from '../../engine/index.ts';
import type { Hold, OwnRules, RunReport, Verdict } from '../../schema/index.ts';
import type { Limits } from '../search-options.ts';
import type { ShownProblem } from '../shown-problem.ts';

/** What a line about a run says. */
export type RunInBrief = Pick<RunReport, 'time' | 'minerals' | 'clearance'>;

/** What `check` found out about one level file. */
export interface CheckedLevel {
  readonly file: string;
  /** The level's name; the file's where it is not a valid level. */
  readonly name: string;
  readonly verdict: Verdict;
  /** The first run that completes the level, scripted or found, else its first run. */
  readonly run: RunInBrief | null;
  /** Its holds when no script has it: a search found it. */
  readonly found: readonly Hold[] | null;
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
  /** Whether it is tried to prove that minerals which no run collects can't be: up to 0.1 s a level. */
  readonly proveMinerals: boolean;
  /** How to search where no scripted run completes a level; null: not at all. */
  readonly search: SearchSettings | null;
  /** Ticks by which all presses and releases of each run that completes a level may be off; null: nothing is required. */
  readonly requireSlack: number | null;
  /** Work that a level may cost, pieces of motion; the engine's default when left out. */
  readonly maxWork?: number;
  /** Rules that the folder sets; none when left out. */
  readonly rules?: OwnRules;
}

/** How a level without a run that completes it is searched. */
export interface SearchSettings {
  /** for each level */
  readonly limits: Limits;
  readonly seed: number;
}
