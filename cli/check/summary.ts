import type { Verdict } from '../../schema/index.ts';
import type { CheckedLevel } from './checked-level.ts';

/** How many levels got which verdict; every verdict is named. */
export function summarize(reports: readonly CheckedLevel[]): Record<Verdict, number> {
  const summary = { completable: 0, broken: 0, unproven: 0, impossible: 0, invalid: 0, crashed: 0 };
  for (const { verdict } of reports) summary[verdict]++;
  return summary;
}

/** 2 when a file could not be read or gq itself failed on it, else 1 when a level is not completable or has an error, else 0. Nothing checked is 2. */
export function exitCodeOf(reports: readonly CheckedLevel[]): 0 | 1 | 2 {
  if (reports.length === 0 || reports.some((r) => r.unreadable || r.verdict === 'crashed')) return 2;
  const isGood = ({ verdict, problems }: CheckedLevel): boolean =>
    verdict === 'completable' && problems.every(({ severity }) => severity === 'warning');
  return reports.every(isGood) ? 0 : 1;
}
