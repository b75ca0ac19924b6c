import type { SolveReport, SolveSetReport } from '../../../../schema/index.ts';
import type { Limits } from '../../../options/index.ts';
import type { ShownProblem } from '../../../report-parts/index.ts';
import type { AskedRuns } from '../../../solve/index.ts';

/** How each level of a set is solved. */
export interface SolveJobSettings extends AskedRuns {
  readonly limits: Limits;
}

export type SolveVerdict = SolveSetReport['levels'][number]['verdict'];

/** What has become of a level. */
export interface SolveRecord {
  readonly name: string;
  readonly verdict: SolveVerdict;
  /** Without the time that it took; null if nothing was tried. */
  readonly solved: SolveReport | null;
  /** Why nothing was tried; null if something was. */
  readonly why: string | null;
  /** The problems of a file that is not a valid level. */
  readonly problems: readonly ShownProblem[];
  /** Whether its file could not be read. */
  readonly unreadable: boolean;
}

/** Nothing was tried. */
export const untried = (name: string, verdict: SolveVerdict, why: string): SolveRecord => ({
  name,
  verdict,
  solved: null,
  why,
  problems: [],
  unreadable: false,
});
