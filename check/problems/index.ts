import { OUTDONE_WARNINGS } from '../../solver/index.ts';
import { completesItself, type Findings, type MoreFindings, verdictOfFindings } from '../findings.ts';
import {
  accuraciesCut,
  foundRun,
  mineralLost,
  nearnessCut,
  noRun,
  noRunFound,
  provedImpossible,
  runsCut,
  softlock,
} from './level-problems.ts';
import type { CheckProblem, Hints, LevelProblem } from './problem.ts';
import { failedRun, hangingRun, tightRun } from './run-problems.ts';
import { unusedAllows } from './unused-allow.ts';

export type { Hints, LevelProblem } from './problem.ts';

/**
 * Lists everything that is wrong or looks wrong in a level.
 * @param findings what a check found out about the level
 * @param hints words that depend on where the problems are read
 * @returns the problems in order: those that decide the verdict, then runs, minerals, warnings, and what is allowed in vain
 */
export function problemsOf(findings: Findings, hints: Hints): LevelProblem[] {
  const { accuracy, range, ends, hangs, cuts, tight, lost } = findings;
  const verdict = verdictOfFindings(findings);
  const isCompletable = verdict === 'completable';
  const problems: LevelProblem[] = [
    ...ofTheLevel(findings, hints),
    ...(cuts.runs === null ? [] : [runsCut(ends, cuts.runs, verdict === 'unproven', hints)]),
    ...ends.flatMap((run, index) =>
      run.outcome === 'completed' || run.isStopped ? [] : [failedRun(run, index, { accuracy, range }, isCompletable, hints)],
    ),
    ...hangs.map((hang) => hangingRun(hang, range, hints)),
    ...(cuts.accuracies === null ? [] : [accuraciesCut(cuts.accuracies, hints)]),
    ...tight.map((run) => tightRun(run, hints.search?.tightRun ?? '')),
    ...lost.map(mineralLost),
    ...softlock(findings.softlocks, hints),
    ...(cuts.nearness === null ? [] : [nearnessCut(cuts.nearness, hints)]),
    ...stillToBeWarnedOf(findings),
  ];
  // a warning that gives way to a proof is still there
  return [...problems, ...unusedAllows(findings, new Set([...problems, ...findings.warnings].map(({ code }) => code)))];
}

/**
 * Lists the problems that proofs show, when nothing else is known of a level yet.
 * @param findings the proofs about the level and its minerals
 * @param hints words that depend on where the problems are read
 * @returns the problems
 */
export const proofProblems = ({ impossible, lost }: Pick<MoreFindings, 'impossible' | 'lost'>, hints: Hints): LevelProblem[] => [
  ...(impossible === null ? [] : [provedImpossible(impossible, hints)]),
  ...lost.map(mineralLost),
];

/** The problem that decides the verdict when none of the level's own runs completes it. */
function ofTheLevel(findings: Findings, hints: Hints): CheckProblem[] {
  const { ends, impossible, searched } = findings;
  if (completesItself(findings)) return [];
  if (impossible !== null) return [provedImpossible(impossible, hints)];
  const hasRuns = ends.length > 0;
  if (searched === null) return hasRuns ? [] : [noRun(hints)];
  return [searched.found === null ? noRunFound(searched, hints.search) : foundRun(searched.found, hasRuns, hints.search)];
}

/** The warnings, without those that say less than a proof. */
function stillToBeWarnedOf({ warnings, impossible, lost }: Findings): LevelProblem[] {
  const outdone = impossible === null ? undefined : OUTDONE_WARNINGS[impossible.code];
  const proved = new Set(lost.map(({ index }) => `/minerals/${index}`));
  const isGuess = ({ code, pointer }: LevelProblem): boolean =>
    code === outdone || ((code === 'mineral-out-of-reach' || code === 'mineral-covered') && proved.has(pointer));
  return warnings.filter((warning) => !isGuess(warning));
}
