import type { CheckReport } from '../../../schema/index.ts';
import type { CheckedLevel } from '../../check/index.ts';
import { summarize } from '../../check/index.ts';
import { problemJson } from '../../report-parts/index.ts';

/** What `check` found out, runs in full, for a program. But for `ms` it is the same whenever and with however many workers it is made. */
export function checkJson(reports: readonly CheckedLevel[]): string {
  const report: CheckReport = {
    levels: reports.map(({ file, name, verdict, report, problems, ms }) => {
      return { file, name, verdict, run: report, problems: problems.map(problemJson), ms };
    }),
    summary: summarize(reports),
  };
  return `${JSON.stringify(report)}\n`;
}
