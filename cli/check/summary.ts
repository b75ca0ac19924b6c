import type { CheckedLevel } from './checked-level.ts';
import { type Totals, totalsOf } from './totals.ts';

/** That there are more warnings than allowed; null if there are not. @param maxWarnings null: any number is allowed */
export function tooManyWarnings({ warnings }: Pick<Totals, 'warnings'>, maxWarnings: number | null): string | null {
  if (maxWarnings === null || warnings <= maxWarnings) return null;
  return `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}: at most ${maxWarnings} allowed (--max-warnings)`;
}

/**
 * 2: nothing was checked, a file could not be read or gq failed; else 1: a level is not completable or has errors, the order of a
 * pack has errors, or there are too many warnings; else 0
 * @param maxWarnings null: any number is allowed
 */
export function exitCodeFor(totals: Totals, maxWarnings: number | null): 0 | 1 | 2 {
  const { levels, good, failed, packErrors } = totals;
  if (levels === 0 || failed > 0) return 2;
  return good === levels && packErrors === 0 && tooManyWarnings(totals, maxWarnings) === null ? 0 : 1;
}

/** The exit code of a check of these levels. */
export const exitCodeOf = (levels: readonly CheckedLevel[], maxWarnings: number | null): 0 | 1 | 2 =>
  exitCodeFor(totalsOf(levels), maxWarnings);
