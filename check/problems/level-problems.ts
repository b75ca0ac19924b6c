import type { Hold, Problem } from '../../schema/index.ts';
import type { Proof, ProofCode } from '../../solver/index.ts';
import type { Searched } from '../findings.ts';
import { type CheckCode, closestInWords, effortInWords, holdsInWords } from '../words/index.ts';
import type { Hints, SearchHints } from './hints.ts';
import type { CheckProblem } from './problem.ts';

/** The problem of a level that has no runs and was not searched. */
export const noRun = ({ firstRun }: Hints): CheckProblem =>
  aboutLevel('no-run', 'error', 'the level has no run, so nothing shows that it can be completed', firstRun);

/** The problem of a level that only a search completed. */
export function foundRun(holds: readonly Hold[], hasRuns: boolean, hints: SearchHints | undefined): CheckProblem {
  const scripted = hasRuns ? 'none of its runs completes the level' : 'the level has no run';
  return aboutLevel(
    'found-run',
    'warning',
    `${scripted}; a search found one that does: ${holdsInWords(holds)}`,
    `keep this run, so that the next check need not search${hints?.keepFound ?? ''}`,
  );
}

/** The problem of a level for which a search found nothing. */
export function noRunFound({ effort, closest }: Searched, hints: SearchHints | undefined): CheckProblem {
  const by = closest === null ? '' : (hints?.nearestRun(holdsInWords(closest.holds)) ?? '');
  const near = closest === null ? '' : `; closest approach ${closestInWords(closest)}${by}`;
  return aboutLevel(
    'no-run-found',
    'error',
    `a search found no run that completes the level, and no proof that there is none: it simulated ${effortInWords(effort)}${near}`,
    hints?.nothingFound ?? '',
  );
}

/** Kinds of proof whose cause lies at the black hole. The cause of the others lies at the start. */
const ABOUT_THE_END: ReadonlySet<ProofCode> = new Set(['out-of-range', 'covered']);

/** The problem of a level that is proved impossible. */
export const provedImpossible = ({ code, reason }: Proof, { seeProof }: Hints): CheckProblem => ({
  code: 'proved-impossible',
  severity: 'error',
  message: `nobody can complete this level: ${reason}`,
  hint: `this is proved (${code}) and confirmed by a separate checker${seeProof}`,
  pointer: ABOUT_THE_END.has(code) ? '/blackHole' : '/astronaut',
});

const aboutLevel = (code: CheckCode, severity: Problem['severity'], message: string, hint: string): CheckProblem => ({
  code,
  severity,
  message,
  hint,
  pointer: '',
});
