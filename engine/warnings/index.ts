import { type Level, rulesOf } from '../../schema/index.ts';
import { boxOf } from '../contact/index.ts';
import type { Run } from '../simulate.ts';
import { aliensExplodeAtStart } from './aliens-explode-at-start.ts';
import { blackHoleCovered } from './black-hole-covered.ts';
import { blackHoleOutOfReach } from './black-hole-out-of-reach.ts';
import { bodiesOf } from './bodies.ts';
import { copiesOf } from './copies.ts';
import { holdsOverlap } from './holds-overlap.ts';
import { holdsUnsorted } from './holds-unsorted.ts';
import { mineralCovered } from './mineral-covered.ts';
import { mineralOutOfReach } from './mineral-out-of-reach.ts';
import { nothingInRangeAtStart } from './nothing-in-range-at-start.ts';
import { overlapping } from './overlapping.ts';
import { reachOf } from './reach.ts';
import { repulsorNeverActs } from './repulsor-never-acts.ts';
import { samePlace } from './same-place.ts';
import { startsInHazard } from './starts-in-hazard.ts';
import { touchesBlackHoleAtStart } from './touches-black-hole-at-start.ts';
import { unusedAsteroid } from './unused-asteroid.ts';
import type { Rule, Warning, WarningExplanation } from './warning.ts';

export type { Warning, WarningExplanation } from './warning.ts';

// in the order in which they are told: first what ends the level, then what is in its way, then what is untidy
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

/** Every code that {@link findWarnings} can give, explained. */
export const WARNING_CODES: readonly WarningExplanation[] = RULES.map((rule) => rule.explanation);

/** A code is told so often in one level; one more warning says that there are others. */
export const MAX_WARNINGS_PER_CODE = 20;

/** The message of that one. */
export const MORE_WARNINGS = `there are more of these: only the first ${MAX_WARNINGS_PER_CODE} are told`;

/**
 * What a valid level's designer most likely didn't mean: found by looking, nothing is simulated.
 * @param runs runs of this level that were simulated; without them `unused-asteroid` is not looked for
 * @returns in a fixed order; empty when all is well
 */
export function findWarnings(level: Level, runs: readonly Run[] = []): Warning[] {
  const rules = rulesOf(level);
  const box = boxOf(rules);
  const subject = { level, rules, box, runs, bodies: bodiesOf(level), reach: reachOf(level, rules), copies: copiesOf(level) };
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
          hint: 'mend these first, then check again',
          pointer: '',
        });
        break;
      }
      warnings.push({ code, severity, ...finding });
    }
  }
  return warnings;
}
