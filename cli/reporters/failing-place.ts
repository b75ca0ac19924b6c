import type { CheckedLevel } from '../check/index.ts';
import { shellPath } from '../shown-path.ts';

/** Where to look at the failure of a level. */
export interface FailingPlace {
  /** The command that shows it. */
  readonly command: string;
  /** The address that opens the editor there; null if no address of a page is known. */
  readonly link: string | null;
  /** The tick at which the run that fails ends; null if no run fails. */
  readonly tick: number | null;
}

/** Whether a level needs attention. */
export const isFailing = ({ verdict, problems }: CheckedLevel): boolean =>
  verdict !== 'completable' || problems.some(({ severity }) => severity === 'error');

/** Where to look at the failure of a level that fails. */
export function placeOfFailure({ file, run }: CheckedLevel): FailingPlace {
  const tick = run === null || run.outcome === 'completed' ? null : run.tick;
  return { command: `gq edit --open ${shellPath(tick === null ? file : `${file}:${tick}`)}`, link: null, tick };
}

/** The same for any level; null if it does not fail. */
export const failureOf = (level: CheckedLevel): FailingPlace | null => (isFailing(level) ? placeOfFailure(level) : null);
