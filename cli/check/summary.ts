import type { Verdict } from '../../schema/index.ts';
import type { CheckedLevel } from './checked-level.ts';

/** The number of levels for each verdict; 0 for verdicts that no level has. */
export function summarize(reports: readonly CheckedLevel[]): Record<Verdict, number> {
  const summary = { completable: 0, broken: 0, unproven: 0, impossible: 0, invalid: 0, crashed: 0 };
  for (const { verdict } of reports) summary[verdict]++;
  return summary;
}

/** The number of problems that are warnings. */
export const countWarnings = (reports: readonly Pick<CheckedLevel, 'problems'>[]): number =>
  reports.reduce((sum, { problems }) => sum + problems.filter(({ severity }) => severity === 'warning').length, 0);

/** That there are more warnings than allowed; null if there are not. @param maxWarnings null: any number is allowed */
export function tooManyWarnings(reports: readonly Pick<CheckedLevel, 'problems'>[], maxWarnings: number | null): string | null {
  const count = countWarnings(reports);
  if (maxWarnings === null || count <= maxWarnings) return null;
  return `${count} ${count === 1 ? 'warning' : 'warnings'}: at most ${maxWarnings} allowed (--max-warnings)`;
}

/**
 * 2: nothing was checked, a file could not be read or gq failed; else 1: a level is not completable or has errors, or there are
 * too many warnings; else 0
 * @param maxWarnings null: any number is allowed
 */
export function exitCodeOf(reports: readonly CheckedLevel[], maxWarnings: number | null): 0 | 1 | 2 {
  if (reports.length === 0 || reports.some((r) => r.unreadable || r.verdict === 'crashed')) return 2;
  const isGood = ({ verdict, problems }: CheckedLevel): boolean =>
    verdict === 'completable' && problems.every(({ severity }) => severity === 'warning');
  return reports.every(isGood) && tooManyWarnings(reports, maxWarnings) === null ? 0 : 1;
}
