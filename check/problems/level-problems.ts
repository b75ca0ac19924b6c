import { TICK } from '../../engine/index.ts';
import { type Hold, objectName, type Problem } from '../../schema/index.ts';
import type { Proof, ProofCode } from '../../solver/index.ts';
import type { Overrun, ScriptEnd, Searched, Softlocks } from '../findings.ts';
import type { LostMineral } from '../proofs.ts';
import { type CheckCode, closestInWords, effortInWords, holdsInWords, plural } from '../words/index.ts';
import type { Hints, LevelProblem, SearchHints } from './problem.ts';

/** The problem of a level that has no runs and was not searched. */
export const noRun = ({ firstRun }: Hints): LevelProblem<CheckCode> =>
  aboutLevel('no-run', 'error', 'the level has no run, so nothing shows that it can be completed', firstRun);

/** The problem of a level that only a search completed. */
export function foundRun(holds: readonly Hold[], hasRuns: boolean, hints: SearchHints | undefined): LevelProblem<CheckCode> {
  const scripted = hasRuns ? 'none of its runs completes the level' : 'the level has no run';
  return aboutLevel(
    'found-run',
    'warning',
    `${scripted}; a search found one that does: ${holdsInWords(holds)}`,
    `keep this run, so that the next check need not search${hints?.keepFound ?? ''}`,
  );
}

/** The problem of a level for which a search found nothing. */
export function noRunFound({ effort, closest }: Searched, hints: SearchHints | undefined): LevelProblem<CheckCode> {
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
export const provedImpossible = ({ code, reason }: Proof, { seeProof }: Hints): LevelProblem<CheckCode> => ({
  code: 'proved-impossible',
  severity: 'error',
  message: `nobody can complete this level: ${reason}`,
  hint: `this is proved (${code}) and confirmed by a separate checker${seeProof}`,
  pointer: ABOUT_THE_END.has(code) ? '/blackHole' : '/astronaut',
});

const aboutLevel = (code: CheckCode, severity: Problem['severity'], message: string, hint: string): LevelProblem<CheckCode> => ({
  code,
  severity,
  message,
  hint,
  pointer: '',
});

/** The problem of a mineral that is proved to be out of reach. */
export const mineralLost = ({ index, proof }: LostMineral): LevelProblem<CheckCode> => ({
  code: 'mineral-never-collectable',
  severity: 'warning',
  message: `nobody can collect ${objectName('mineral', index)}: ${proof.reason}`,
  hint: `this is proved (${proof.code}) and confirmed by a separate checker: move the mineral, or what keeps her from it`,
  pointer: `/minerals/${index}`,
});

/** She lives on for long if she was seen alive for this long after all is lost, s. */
const LONG = 5;

/** The problem that she can live on for long after it is proved to be lost. */
export function softlock(found: Softlocks | null, { seeLost }: Hints): LevelProblem<CheckCode>[] {
  const long = found?.places.filter(({ standing, alive }) => standing.is === 'proved' && alive * TICK >= LONG) ?? [];
  const [worst] = long;
  if (worst?.standing.is !== 'proved') return [];
  const more = long.length === 1 ? '' : `, and at ${plural(long.length - 1, 'more place')}`;
  return [
    {
      code: 'softlock',
      severity: 'warning',
      message:
        `she can live on for ${(worst.alive * TICK).toFixed(1)} s and more although the black hole is out of her reach: ` +
        `from ${(worst.tick * TICK).toFixed(2)} s on at (${Math.round(worst.x)}, ${Math.round(worst.y)})${more}`,
      hint: `this is proved (${worst.standing.proof.code}) and confirmed by a separate checker: end the run there, or open a way back${seeLost}`,
      pointer: '',
    },
  ];
}

/**
 * The problem of runs that were not simulated to their end.
 * @param isUnproven whether nothing else decides the verdict
 */
export function runsCut(ends: readonly ScriptEnd[], by: Overrun, isUnproven: boolean, hints: Hints): LevelProblem<CheckCode> {
  const index = ends.findIndex(({ isStopped }) => isStopped);
  const { name, tick } = ends[index];
  const more = ends.filter(({ isStopped }) => isStopped).length - 1;
  const others = more > 0 ? `, and the ${plural(more, 'run')} after it ${more === 1 ? 'was' : 'were'} not played at all` : '';
  const what = `run ${JSON.stringify(name)} was not played beyond tick ${tick}${others}`;
  return { ...workLimit(what, `/runs/${index}`, by, hints), severity: isUnproven ? 'error' : 'warning' };
}

/** The problem of runs that were not compared at other accuracies. */
export const accuraciesCut = (by: Overrun, hints: Hints): LevelProblem<CheckCode> =>
  workLimit('its runs were not compared at every accuracy', '/runs', by, hints);

/** The problem of a level in which it was not examined what the runs come near to. */
export const nearnessCut = (by: Overrun, hints: Hints): LevelProblem<CheckCode> =>
  workLimit('the warnings that depend on its runs were left out', '/runs', by, hints);

/** @param what what was left out, as the beginning of a sentence */
function workLimit(what: string, pointer: string, { maxWork, of }: Overrun, { moreWork }: Hints): LevelProblem<CheckCode> {
  const ran = of === 'work' ? `more than the ${maxWork} pieces of motion allowed` : 'more memory for its recordings than allowed';
  return {
    code: 'work-limit',
    severity: 'warning',
    message: `${what}: that takes ${ran}`,
    hint: `delete what the level does not need${moreWork}`,
    pointer,
  };
}
