import {
  applyPolicy,
  findingsOf,
  type Hints,
  type LevelProblem,
  type LevelVerdict,
  type LostMineral,
  onceProved,
  problemsOf,
  proofProblems,
  type RunFindings,
  unproved,
  verdictOfFindings,
} from '../../../check/index.ts';
import type { Problem } from '../../../schema/index.ts';
import type { Proof } from '../../../solver/index.ts';
import { type Limit, type LiveProof, limitInWords } from './answer.ts';

/** What a worker has proved about a level. */
export interface Proved {
  readonly impossible: Proof | null;
  readonly minerals: readonly LostMineral[];
  /** Whether everything was tried that a check tries; false when missing. */
  readonly isWhole?: boolean;
  /** Why the search for proofs ended early; null: it did not, or is still running. */
  readonly gaveUp?: string | null;
}

/** What a worker found out about a level that the page does not simulate itself. */
export interface FoundByWorker {
  /** null: it gave up as well */
  readonly result: RunFindings | null;
  /** Why it gave up. */
  readonly message: string;
}

/** The verdict on a level as far as it is known. @param worker null: not asked, or not done */
export function knownVerdict(
  { verdict: own }: Pick<LiveProof, 'verdict'>,
  worker: FoundByWorker | null,
  { impossible }: Pick<Proved, 'impossible'>,
): LevelVerdict {
  const played = worker === null || worker.result === null ? null : verdictOfFindings({ ...worker.result, ...unproved });
  // one run that completes the level is enough
  return onceProved(own === 'completable' ? own : (played ?? own), impossible !== null);
}

/**
 * The problems of a level as far as they are known; `line` and `column` are null. @param worker null: not asked, or not done
 */
export function knownProblems(
  { findings: own, limit }: Pick<LiveProof, 'findings' | 'limit'>,
  worker: FoundByWorker | null,
  { impossible, minerals: lost, isWhole = false, gaveUp = null }: Proved,
): Problem[] {
  const findings = own ?? worker?.result ?? null;
  const known: LevelProblem[] = [];
  if (findings !== null)
    known.push(
      ...problemsOf(
        findingsOf(findings, { impossible, lost, sought: { slack: null, minerals: isWhole, softlocks: false } }),
        PAGE_HINTS,
      ),
    );
  else {
    known.push(...proofProblems({ impossible, lost }, PAGE_HINTS));
    if (limit !== null) known.push(limitProblem(limit, worker?.message ?? null));
  }
  if (gaveUp !== null && impossible === null) known.push(proofsGivenUp(gaveUp));
  const { problems } = applyPolicy(known, { severity: {}, allow: findings?.allow ?? {} });
  return problems.map((problem) => ({ ...problem, line: null, column: null }));
}

/**
 * The problem that stands for problems that are not known.
 * @param message why a worker, which has more patience, does not know them either; null: not asked, or not done
 */
const limitProblem = (limit: Limit, message: string | null): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: message ?? limitInWords(limit),
  hint: limit === 'unchecked' ? 'turn checks on to simulate it' : 'delete objects, aliens above all, or runs',
  pointer: '',
});

/** The problem for proofs whose search ended early. @param why the beginning of a sentence */
const proofsGivenUp = (why: string): LevelProblem => ({
  code: 'work-limit',
  severity: 'warning',
  message: `${why}: the page could not decide whether something is out of reach`,
  hint: 'gq check may search longer; fewer objects make it faster',
  pointer: '',
});

/** Hints of problems on the page. */
export const PAGE_HINTS: Hints = {
  firstRun: 'play the level and keep an attempt as a run, or let the solver find a run',
  // both are visible: the run on the canvas, the others a click away
  seeRun: () => '',
  seeAccuracies: () => '; the accuracy panel shows the result at each setting',
  moreWork: ', aliens above all',
  seeLost: '',
  seeProof: ': move the objects that the reason names',
};
