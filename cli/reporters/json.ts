import type { CheckReport } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { problemJson } from '../report-parts/index.ts';
import { failureOf } from '../show-failure/index.ts';
import type { ReportContext, Results } from './reporter.ts';

/** The results of `check` as JSON, with runs in full. Except for `ms`, it does not depend on time or the number of workers. */
export const checkJson = (results: Results, { linkTo }: ReportContext): string =>
  [...checkJsonOf(results.levels, results, linkTo)].join('');

/** The same in pieces, for any number of levels. */
export function* checkJsonOf(
  levels: Iterable<CheckedLevel>,
  { totals, unchecked, interrupted }: Pick<Results, 'totals' | 'unchecked' | 'interrupted'>,
  linkTo: ReportContext['linkTo'],
): Generator<string> {
  const {
    version,
    levels: _,
    ...rest
  }: CheckReport = {
    version: 1,
    levels: [],
    summary: totals.summary,
    interrupted,
    unchecked: [...unchecked],
  };
  yield `{"version":${version},"levels":[`;
  let comma = '';
  for (const level of levels) {
    yield comma + JSON.stringify(levelJson(level, linkTo));
    comma = ',';
  }
  yield `],${JSON.stringify(rest).slice(1)}\n`;
}

function levelJson(level: CheckedLevel, linkTo: ReportContext['linkTo']): CheckReport['levels'][number] {
  const { file, name, verdict, report: run, problems, ms } = level;
  return { file, name, verdict, run, problems: problems.map(problemJson), failure: failureOf(level, linkTo), ms };
}
