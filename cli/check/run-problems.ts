import type { Run, WorkBudget } from '../../engine/index.ts';
import type { Level, Problem } from '../../schema/index.ts';
import type { Candidate, Proof, ProofCode } from '../../solver/index.ts';
import { outcomeInWords } from '../outcome.ts';
import type { LostMineral } from '../prove.ts';
import { closestInWords, effortInWords, holdsInWords } from '../report-parts/index.ts';
import { shellPath } from '../shown-path.ts';
import type { Searched } from './search-level.ts';

/** Of a level without runs that was not searched. */
export const noRun = (file: string): Problem =>
  aboutLevel(
    'no-run',
    'error',
    'the level has no run, so nothing shows that it can be completed',
    `let one be found: gq solve ${shellPath(file)} --write; or add "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s`,
  );

interface FailedRun {
  readonly file: string;
  readonly level: Level;
  readonly accuracy: string;
  /** Of the run in the level's list. */
  readonly index: number;
  readonly run: Run;
  /** Nothing else shows that the level can be completed. */
  readonly noneCompletes: boolean;
}

/** Of a run that does not complete its level: an error when none does, a warning beside one that does. */
export function failedRun({ file, level, accuracy, index, run, noneCompletes }: FailedRun): Omit<Problem, 'line' | 'column'> {
  const name = JSON.stringify(level.runs[index].name);
  const todo = noneCompletes ? 'move what is in the way or change the run' : 'another run does: mend this one or take it out';
  return {
    code: 'run-does-not-complete',
    severity: noneCompletes ? 'error' : 'warning',
    message: `run ${name} does not complete the level under ${accuracy}: ${outcomeInWords(run, level)}`,
    hint: `${todo}; see gq simulate ${shellPath(file)} --run ${name}`,
    pointer: `/runs/${index}`,
  };
}

/** What was left out for want of work, as a sentence ends. */
export interface CutShort {
  /** as a sentence begins */
  readonly what: string;
  readonly pointer: string;
}

/** Of a level that costs more than allowed. */
export function workLimit(
  { what, pointer }: CutShort,
  { maxWork, spent }: Pick<WorkBudget, 'maxWork' | 'spent'>,
  isError: boolean,
): Omit<Problem, 'line' | 'column'> {
  const ran =
    spent >= maxWork ? `more than the ${maxWork} pieces of motion allowed` : 'more memory for its recording than allowed';
  return {
    code: 'work-limit',
    severity: isError ? 'error' : 'warning',
    message: `${what}: that takes ${ran}`,
    hint: 'take out what the level does not need, or allow more work with --max-work; see gq explain work-limit',
    pointer,
  };
}

/** Of a level that a search completed where its scripts don't. */
export function foundRun(file: string, { holds }: Pick<Candidate, 'holds'>, hasRuns: boolean): Problem {
  const scripted = hasRuns ? 'none of its runs completes the level' : 'the level has no run';
  return aboutLevel(
    'found-run',
    'warning',
    `${scripted}; a search found one that does: ${holdsInWords(holds)}`,
    `keep it, so that the next check need not search: gq solve ${shellPath(file)} --write`,
  );
}

/** Of a level for which nothing was found. */
export function noRunFound({ effort, closest }: Searched): Problem {
  const near = closest === null ? '' : `; the nearest was ${closestInWords(closest)}`;
  return aboutLevel(
    'no-run-found',
    'error',
    `a search found no run that completes the level, and no proof that there is none: ${effortInWords(effort)} simulated${near}`,
    'look at the nearest with gq render --holds, make the level easier, or search longer: --budget, gq solve',
  );
}

/** Proofs that say what is wrong where the black hole is; the others, what is wrong where she starts. */
const ABOUT_THE_END: ReadonlySet<ProofCode> = new Set(['out-of-range', 'covered']);

/** Of a level that nobody can complete. */
export function provedImpossible(file: string, { code, reason }: Proof): Omit<Problem, 'line' | 'column'> {
  return {
    code: 'proved-impossible',
    severity: 'error',
    message: `nobody can complete this level: ${reason}`,
    hint: `proved (${code}), and confirmed by a separate checker: gq render ${shellPath(file)} --proof -o proof.svg draws why`,
    pointer: ABOUT_THE_END.has(code) ? '/blackHole' : '/astronaut',
  };
}

/** Of a mineral that nobody can collect. */
export function mineralLost({ index, proof }: LostMineral): Omit<Problem, 'line' | 'column'> {
  return {
    code: 'mineral-never-collectable',
    severity: 'warning',
    message: `nobody can collect minerals[${index}]: ${proof.reason}`,
    hint: `proved (${proof.code}), and confirmed by a separate checker: move the mineral, or what keeps her from it`,
    pointer: `/minerals/${index}`,
  };
}

const aboutLevel = (code: string, severity: Problem['severity'], message: string, hint: string): Problem => ({
  code,
  severity,
  message,
  hint,
  pointer: '',
  line: null,
  column: null,
});
