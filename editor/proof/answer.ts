import type { LevelVerdict, RunFindings } from '../../check/index.ts';
import { outcomeAsPredicate, type RunEnd } from '../../check/words/index.ts';
import type { AccuracyName, Run, Scene } from '../../engine/index.ts';
import type { Hold, Level, LevelFile, OwnRules, Problem } from '../../schema/index.ts';
import type { Marched, Way } from './march.ts';
import type { Margins } from './margins.ts';
import { type Limit, limitInWords } from './patience.ts';

/** What is asked of a level while it is edited. */
export interface Question {
  readonly file: LevelFile;
  /** Rules that the folder sets, which hold where the level has none of its own; none when left out. */
  readonly rules?: OwnRules;
  /** Name of the run that is shown; the first one when there is none of that name or it is null. */
  readonly run: string | null;
  readonly accuracy: AccuracyName;
  /** How long the answer may take, ms, about: what takes longer is left out and said. No limit when left out; 0: nothing is played. */
  readonly patience?: number;
}

/** The run that is shown, simulated. */
export interface ShownRun extends RunEnd {
  /** null where the level has no run: she drifts */
  readonly name: string | null;
  /** as they act: sorted and joined */
  readonly holds: readonly Hold[];
  readonly way: Way;
  /** those collected, each once, with the tick */
  readonly minerals: Marched['minerals'];
  /** The tick from which on this was simulated anew. */
  readonly resumedFrom: number;
}

/** Everything the editor shows about a level that is not in its file. Arrays in `run.way` are good until the next answer. */
export interface LiveProof {
  readonly file: LevelFile;
  /** With the rules of its folder where it has none of its own. */
  readonly level: Level;
  /** Of the same objects as `level`; its runs may be older ones. */
  readonly scene: Scene;
  readonly accuracy: AccuracyName;
  readonly run: ShownRun;
  /** As `gq check` has it, but for what is proved: that is found by a worker. */
  readonly verdict: LevelVerdict;
  /** What was left out; null: nothing, all here is as `gq check` has it. Otherwise the verdict is what is known without. */
  readonly limit: Limit | null;
  /** Name of a run that completes the level: the shown one if it does, else the first; null where none does. */
  readonly provenBy: string | null;
  /** What this answer cost, ms of wall time. */
  readonly ms: number;
  /** What the runs show and what looks wrong. Made when asked for: it simulates all runs in full; null where something was left out. */
  readonly findings: RunFindings | null;
  /** What is wrong as far as the page knows by itself: without what a worker proves. Made when asked for, like `findings`. */
  readonly problems: readonly Problem[];
  /** The shown run with its events, exact times and hash. Made when asked for; null where it was not played to its end. */
  readonly full: Run | null;
  /** Clearance and speed along the shown run. Made when asked for. */
  readonly margins: Margins;
}

/** Whether the shown run was played to its end. */
export const isWhole = ({ limit }: Pick<LiveProof, 'limit'>): boolean => limit === null || limit === 'others';

/** How the shown run ends, as what follows its name or "she", or why that is not known. */
export const endInWords = ({ limit, run, level }: Pick<LiveProof, 'limit' | 'run' | 'level'>): string =>
  limit === null || limit === 'others' ? outcomeAsPredicate(run, level.range) : limitInWords(limit);
