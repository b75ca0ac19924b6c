import type { LevelVerdict, RunFindings } from '../../../check/index.ts';
import { outcomeAsPredicate, type RunEnd } from '../../../check/words/index.ts';
import type { Run, Scene, Terms } from '../../../engine/index.ts';
import type { Hold, Level, LevelFile, Problem } from '../../../schema/index.ts';
import type { Margins } from './margins.ts';
import type { RecordedRun, Way } from './recorder.ts';

/** A request of the editor. */
export interface Question {
  readonly file: LevelFile;
  /** The shown run; the first one if the name is null or unknown. */
  readonly run: string | null;
  /** Under which the level is simulated; the same object for the same terms. */
  readonly terms: Terms;
  /**
   * Approximate time limit of the answer, ms: what takes longer is left out, and `limit` says so. No limit if absent; 0:
   * nothing is simulated.
   */
  readonly patience?: number;
}

/** The shown run, simulated. */
export interface ShownRun extends RunEnd {
  /** null if the level has no run: she drifts */
  readonly name: string | null;
  /** effective holds: sorted and joined */
  readonly holds: readonly Hold[];
  readonly way: Way;
  /** the collected minerals, each once, with the tick */
  readonly minerals: RecordedRun['minerals'];
  /** The tick from which on the run was simulated again. */
  readonly resumedFrom: number;
}

/** Everything that the editor shows about a level besides its file. Arrays in `run.way` are valid until the next answer. */
export interface LiveProof {
  readonly file: LevelFile;
  /** With the rules of its folder where the level sets none. */
  readonly level: Level;
  /** Has the same objects as `level`; its runs may be older. */
  readonly scene: Scene;
  /** Under which all this holds. */
  readonly terms: Terms;
  readonly run: ShownRun;
  /** The verdict of `gq check` under these terms, but without proofs, which a worker finds. */
  readonly verdict: LevelVerdict;
  /** What was left out; null: nothing, and everything agrees with `gq check`. Otherwise the verdict is based on the rest. */
  readonly limit: Limit | null;
  /** The name of a run that completes the level: the shown one if possible, else the first; null if none does. */
  readonly provenBy: string | null;
  /** the cost of this answer, ms of wall time */
  readonly ms: number;
  /**
   * The findings of all runs and warnings. Computed on demand, as it simulates all runs completely; null if something was left
   * out.
   */
  readonly findings: RunFindings | null;
  /** The problems that the page can find itself, without proofs of a worker. Computed on demand, like `findings`. */
  readonly problems: readonly Problem[];
  /** The shown run with its events, exact times and hash. Computed on demand; null if it was not simulated to its end. */
  readonly full: Run | null;
  /** Clearance and speed along the shown run. Computed on demand. */
  readonly margins: Margins;
}

/** Whether the shown run was simulated to its end. */
export const isWhole = ({ limit }: Pick<LiveProof, 'limit'>): boolean => limit === null || limit === 'others';

/** How the shown run ends, to follow its name or "she"; or why that is not known. */
export const endInWords = ({ limit, run, level }: Pick<LiveProof, 'limit' | 'run' | 'level'>): string =>
  limit === null || limit === 'others' ? outcomeAsPredicate(run, level.range) : limitInWords(limit);

/** What the page did not simulate of a level, to stay responsive. A worker simulates all of it. */
export type Limit =
  /** checks are off: nothing is simulated */
  | 'unchecked'
  /** nothing: even the start takes too much work */
  | 'everything'
  /** the shown run from the end of its trajectory on */
  | 'run'
  /** other runs, which may complete the level; the shown run is complete */
  | 'others';

/** ms that an answer may block the page during a drag: the user sees ten or more updates per second */
export const WHILE_DRAGGED = 60;
/** the same once the level is at rest */
export const AT_REST = 400;

/** pieces of motion that the page simulates per answer; also limits the work within a tick, where the clock is not read */
export const MOST_WORK = 50_000;

/** The level without everything that makes it slow, to show a level that is not simulated. */
export const bareOf = (level: Level): Level => ({
  ...level,
  asteroids: [],
  novae: [],
  repulsors: [],
  aliens: [],
  minerals: [],
  runs: [],
});

/** Why a level is not simulated to its end, in words. */
export function limitInWords(limit: Limit): string {
  switch (limit) {
    case 'unchecked':
      return 'not simulated: checks are off for this level';
    case 'everything':
      return 'work limit: the level takes too much work to be simulated while it is edited';
    case 'run':
      return 'work limit: the run takes too much work to be simulated to its end while it is edited';
    case 'others':
      return 'work limit: not all runs of the level could be simulated while it is edited';
  }
}
