import type { LevelReport } from '../check/report.ts';
import { summarize } from '../check/summary.ts';
import { problemJson } from './problem-json.ts';

/** What `check` found out, for a program. But for `ms` it is the same whenever and with however many workers it is made. */
export function checkJson(reports: readonly LevelReport[]): string {
  const levels = reports.map(({ file, name, verdict, run, problems, ms }) => {
    return { file, name, verdict, run, problems: problems.map(problemJson), ms };
  });
  return `${JSON.stringify({ levels, summary: summarize(reports) })}\n`;
}
