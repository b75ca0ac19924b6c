import type { CheckReport } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { jsonWithLevels, problemJson } from '../report-parts/index.ts';
import { failureOf } from '../show-failure/index.ts';
import type { ReportContext, Results } from './reporter.ts';

/** The results of `check` as JSON, with runs in full. Except for `ms`, it does not depend on time or the number of workers. */
export const checkJson = (results: Results, { linkTo }: ReportContext): string =>
  [...checkJsonOf(results.levels, results, linkTo)].join('');

/** The same in pieces, for any number of levels. */
export function checkJsonOf(
  levels: Iterable<CheckedLevel>,
  { totals, unchecked, interrupted, packs = [] }: Pick<Results, 'totals' | 'unchecked' | 'interrupted' | 'packs'>,
  linkTo: ReportContext['linkTo'],
): Iterable<string> {
  const rest: Omit<CheckReport, 'version' | 'levels'> = {
    ...(packs.length > 0 && {
      packs: packs.map(({ file, name, problems }) => ({ file, name, problems: problems.map(problemJson) })),
    }),
    summary: totals.summary,
    interrupted,
    unchecked: [...unchecked],
  };
  return jsonWithLevels(levels, (level) => levelJson(level, linkTo), rest);
}

function levelJson(level: CheckedLevel, linkTo: ReportContext['linkTo']): CheckReport['levels'][number] {
  const { file, name, terms, verdict, report: run, problems, softlocks, ms } = level;
  const lost = softlocks === undefined ? {} : { softlocks };
  const failure = failureOf(level, linkTo);
  return { file, name, terms, verdict, run, problems: problems.map(problemJson), failure, ...lost, ms };
}
