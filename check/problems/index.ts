import type { AllowableCode } from '../../schema/index.ts';
import { OUTDONE_WARNINGS } from '../../solver/index.ts';
import { completesItself, type Findings, type MoreFindings, verdictOfFindings } from '../findings.ts';
import type { CheckCode } from '../words/index.ts';
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
import type { Hints, LevelProblem } from './problem.ts';
import { failedRun, hangingRun, tightRun } from './run-problems.ts';

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
  if (Object.keys(findings.allow).length === 0) return problems;
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
function ofTheLevel(findings: Findings, hints: Hints): LevelProblem<CheckCode>[] {
  const { ends, impossible, searched } = findings;
  if (completesItself(findings)) return [];
  if (impossible !== null) return [provedImpossible(impossible, hints)];
  const hasRuns = ends.length > 0;
  if (searched === null) return hasRuns ? [] : [noRun(hints)];
  return [searched.found === null ? noRunFound(searched, hints.search) : foundRun(searched.found, hasRuns, hints.search)];
}

/** The warnings, without those that say less than a proof. */
function stillToBeWarnedOf({ warnings, impossible, lost }: Findings): readonly LevelProblem[] {
  if (warnings.length === 0) return warnings;
  const outdone = impossible === null ? undefined : OUTDONE_WARNINGS[impossible.code];
  const proved = new Set(lost.map(({ index }) => `/minerals/${index}`));
  const isGuess = ({ code, pointer }: LevelProblem): boolean =>
    code === outdone || ((code === 'mineral-out-of-reach' || code === 'mineral-covered') && proved.has(pointer));
  return warnings.filter((warning) => !isGuess(warning));
}

/** What depends on a run that completes the level. Without one, nothing is known of it. */
const ABOUT_COMPLETING_RUNS: ReadonlySet<string> = new Set([
  'unused-asteroid',
  'low-slack',
  'slack-below-required',
  'verdict-hangs-on-accuracy',
] satisfies AllowableCode[]);

/** Whether the check would have found a problem of this code. */
function isSought(code: string, findings: Findings): boolean {
  const { cuts, sought } = findings;
  if (ABOUT_COMPLETING_RUNS.has(code) && verdictOfFindings(findings) !== 'completable') return false;
  switch (code) {
    case 'low-slack':
      return sought.slack === 'low';
    case 'slack-below-required':
      return sought.slack === 'required';
    case 'softlock':
      return sought.softlocks;
    case 'mineral-never-collectable':
      return sought.minerals;
    case 'run-does-not-complete':
      return cuts.runs === null;
    case 'verdict-hangs-on-accuracy':
      return cuts.runs === null && cuts.accuracies === null;
    case 'unused-asteroid':
      return completesItself(findings) && cuts.runs === null && cuts.nearness === null;
    // a search only reports it where it was needed, and other limits of work find other levels
    case 'found-run':
    case 'work-limit':
      return false;
    default:
      return true;
  }
}

/**
 * The problems of what a level allows although it is not there.
 * @param codes the codes of the problems that are there
 */
function unusedAllows(findings: Findings, codes: ReadonlySet<string>): LevelProblem<CheckCode>[] {
  return Object.keys(findings.allow).flatMap((code) =>
    codes.has(code) || !isSought(code, findings)
      ? []
      : [
          {
            code: 'unused-allow',
            severity: 'warning',
            message: `the level allows ${code}, but has no problem of this kind`,
            hint: `remove ${code} from "allow"`,
            pointer: `/allow/${code}`,
          },
        ],
  );
}
