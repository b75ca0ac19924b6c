import type { Overrun, ScriptEnd } from '../findings.ts';
import { plural } from '../words/index.ts';
import type { Hints } from './hints.ts';
import type { CheckProblem } from './problem.ts';

/**
 * The problem of runs that were not simulated to their end.
 * @param isUnproven whether nothing else decides the verdict
 */
export function runsCut(ends: readonly ScriptEnd[], by: Overrun, isUnproven: boolean, hints: Hints): CheckProblem {
  const index = ends.findIndex(({ isStopped }) => isStopped);
  const { name, tick } = ends[index];
  const more = ends.filter(({ isStopped }) => isStopped).length - 1;
  const others = more > 0 ? `, and the ${plural(more, 'run')} after it ${more === 1 ? 'was' : 'were'} not played at all` : '';
  const what = `run ${JSON.stringify(name)} was not played beyond tick ${tick}${others}`;
  return { ...workLimit(what, `/runs/${index}`, by, hints), severity: isUnproven ? 'error' : 'warning' };
}

/** The problem of runs that were not compared at other accuracies. */
export const accuraciesCut = (by: Overrun, hints: Hints): CheckProblem =>
  workLimit('its runs were not compared at every accuracy', '/runs', by, hints);

/** The problem of a level in which it was not examined what the runs come near to. */
export const nearnessCut = (by: Overrun, hints: Hints): CheckProblem =>
  workLimit('the warnings that depend on its runs were left out', '/runs', by, hints);

/** @param what what was left out, as the beginning of a sentence */
function workLimit(what: string, pointer: string, { maxWork, of }: Overrun, { moreWork }: Hints): CheckProblem {
  const ran = of === 'work' ? `more than the ${maxWork} pieces of motion allowed` : 'more memory for its recordings than allowed';
  return {
    code: 'work-limit',
    severity: 'warning',
    message: `${what}: that takes ${ran}`,
    hint: `delete what the level does not need${moreWork}`,
    pointer,
  };
}
