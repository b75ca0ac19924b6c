import type { CheckReport } from '../../schema/index.ts';
import { summarize } from '../check/index.ts';
import { problemJson } from '../report-parts/index.ts';
import { failureOf } from '../show-failure/index.ts';
import type { ReportContext, Results } from './reporter.ts';

/** The results of `check` as JSON, with runs in full. Except for `ms`, it does not depend on time or the number of workers. */
export function checkJson({ levels, unchecked, interrupted }: Results, { linkTo }: ReportContext): string {
  const report: CheckReport = {
    version: 1,
    levels: levels.map((level) => {
      const { file, name, verdict, report: run, problems, ms } = level;
      return { file, name, verdict, run, problems: problems.map(problemJson), failure: failureOf(level, linkTo), ms };
    }),
    summary: summarize(levels),
    interrupted,
    unchecked: [...unchecked],
  };
  return `${JSON.stringify(report)}\n`;
}
