import { type Level, rulesOf } from '../../schema/basics/index.ts';
import { MAX_WARNINGS_PER_CODE, MORE_WARNINGS } from '../constants.ts';
import { boxOf } from '../contact.ts';
import type { Run } from '../simulate.ts';
import { DEFAULT_TERMS, type Terms } from '../terms.ts';
import { nothingInRangeAtStart, startsInHazard, touchesBlackHoleAtStart } from './at-start.ts';
import { blackHoleCovered, blackHoleOutOfReach } from './black-hole.ts';
import { bodiesOf, copiesOf } from './bodies.ts';
import { holdsOverlap, holdsUnsorted } from './holds.ts';
import { mineralCovered, mineralOutOfReach } from './minerals.ts';
import { aliensExplodeAtStart, overlapping, samePlace } from './overlapping.ts';
import { reachOf } from './reach.ts';
import { repulsorNeverActs } from './repulsor-never-acts.ts';
import { unusedAsteroid } from './unused-asteroid.ts';
import type { Rule, Warning, WarningExplanation } from './warning.ts';

export { MAX_WARNINGS_PER_CODE, MORE_WARNINGS } from '../constants.ts';
export type { Warning, WarningExplanation } from './warning.ts';

// in the order in which they are reported: what ends the level, then what obstructs it, then what is untidy
const RULES: readonly Rule[] = [
  nothingInRangeAtStart,
  startsInHazard,
  touchesBlackHoleAtStart,
  blackHoleOutOfReach,
  blackHoleCovered,
  mineralOutOfReach,
  mineralCovered,
  aliensExplodeAtStart,
  repulsorNeverActs,
  samePlace,
  overlapping,
  holdsOverlap,
  holdsUnsorted,
  unusedAsteroid,
];

/** The explanations of all codes that {@link findWarnings} can give. */
export const WARNING_CODES: readonly WarningExplanation[] = RULES.map((rule) => rule.explanation);

/**
 * Finds what the designer of a valid level most likely did not intend. It examines the level only; nothing is simulated.
 *
 * @param level - a valid level
 * @param runs - simulated runs of this level; without any, `unused-asteroid` is not looked for
 * @param terms - how long a run may last; {@link DEFAULT_TERMS} when left out
 * @returns the warnings in a fixed order; empty if there are none
 */
export function findWarnings(
  level: Level,
  runs: readonly Run[] = [],
  { maxTime }: Pick<Terms, 'maxTime'> = DEFAULT_TERMS,
): Warning[] {
  const rules = rulesOf(level);
  const box = boxOf(rules);
  const reach = reachOf(level, rules, maxTime);
  const subject = { level, rules, box, runs, bodies: bodiesOf(level), reach, copies: copiesOf(level) };
  const warnings: Warning[] = [];
  for (const { explanation, find } of RULES) {
    const { code, severity } = explanation;
    let count = 0;
    for (const finding of find(subject)) {
      if (++count > MAX_WARNINGS_PER_CODE) {
        warnings.push({
          code,
          severity,
          message: MORE_WARNINGS,
          hint: 'fix these first, then check again',
          pointer: '',
        });
        break;
      }
      warnings.push({ code, severity, ...finding });
    }
  }
  return warnings;
}
