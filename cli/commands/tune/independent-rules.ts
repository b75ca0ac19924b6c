import { RULE_NAMES, type RuleName } from '../../../schema/index.ts';
import type { TunedLevel } from '../../tune/index.ts';

/** The rules that were tried and that no level depends on. */
export function independentRules(levels: readonly TunedLevel[]): RuleName[] {
  const intervals = levels.flatMap((level) => level.intervals);
  return RULE_NAMES.filter((name) => {
    const tried = intervals.filter(({ rule }) => rule === name);
    return tried.length > 0 && tried.every(({ matters }) => !matters);
  });
}
