import type { CheckReport } from '../../../schema/index.ts';
import type { CheckedLevel } from '../../check/index.ts';
import { summarize } from '../../check/index.ts';
import { problemJson } from '../../report-parts/index.ts';

/** The results of `check` as JSON, with runs in full. Except for `ms`, it does not depend on time or the number of workers. */
export function checkJson(reports: readonly CheckedLevel[]): string {
  const report: CheckReport = {
    levels: reports.map(({ file, name, verdict, report, problems, ms }) => {
      return { file, name, verdict, run: report, problems: problems.map(problemJson), ms };
    }),
    summary: summarize(reports),
  };
  return `${JSON.stringify(report)}\n`;
}
