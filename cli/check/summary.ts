import type { Verdict } from '../../schema/index.ts';
import type { CheckedLevel } from './checked-level.ts';

/** The number of levels for each verdict; 0 for verdicts that no level has. */
export function summarize(reports: readonly CheckedLevel[]): Record<Verdict, number> {
  const summary = { completable: 0, broken: 0, unproven: 0, impossible: 0, invalid: 0, crashed: 0 };
  for (const { verdict } of reports) summary[verdict]++;
  return summary;
}

/** 2: nothing was checked, a file could not be read or gq failed; else 1: a level is not completable or has errors; else 0 */
export function exitCodeOf(reports: readonly CheckedLevel[]): 0 | 1 | 2 {
  if (reports.length === 0 || reports.some((r) => r.unreadable || r.verdict === 'crashed')) return 2;
  const isGood = ({ verdict, problems }: CheckedLevel): boolean =>
    verdict === 'completable' && problems.every(({ severity }) => severity === 'warning');
  return reports.every(isGood) ? 0 : 1;
}
