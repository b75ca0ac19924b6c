import { termsReport } from '../../check/words/index.ts';
import type { SolutionReport, SolveReport } from '../../schema/index.ts';
import type { Solution } from '../../solver/index.ts';
import { robustnessJson } from '../report-parts/index.ts';
import type { SolveSettings } from './settings.ts';
import type { Solved, SolvedRun } from './solve-level.ts';

/** The results of `solve` as JSON has them. */
export function solveReport({ level, terms, seed, count }: SolveSettings, solved: Solved): SolveReport {
  const { runs, closest, impossible } = solved;
  const under = termsReport({ terms, level });
  const effort = { ...solved.effort, seconds: solved.seconds, seed };
  const toReport = (found: SolvedRun | undefined): SolutionReport => ({
    level: level.name,
    accuracy: terms.accuracy.name,
    terms: under,
    found: found !== undefined,
    holds: found === undefined ? null : holdsOf(found),
    outcome: found?.run.outcome ?? null,
    time: found?.run.time ?? null,
    tick: found?.run.tick ?? null,
    minerals: [...(found?.run.minerals ?? [])],
    effort,
    robustness: found === undefined ? null : robustnessJson(found.robustness),
    closest: closest === null ? null : { ...closest, holds: holdsOf(closest) },
    impossible:
      impossible === null
        ? null
        : { code: impossible.code, reason: impossible.reason, certificate: jsonOf(impossible.certificate) },
    hash: found?.run.hash ?? null,
  });
  const report: SolveReport = { version: 1, ...toReport(runs[0]) };
  if (count > 1) report.solutions = runs.map(toReport);
  return report;
}

const holdsOf = ({ holds }: Pick<Solution, 'holds'>): [number, number][] => holds.map(([press, release]) => [press, release]);

const jsonOf = (certificate: unknown) => certificate as NonNullable<SolutionReport['impossible']>['certificate'];
