import fc from 'fast-check';
import { type OwnRules, RULE_NAMES, RULES, type RuleName } from '../../schema/index.ts';

/**
 * A value of a rule: the original's, an end of the allowed interval, or anything between, small values as often as large ones.
 */
function someValue(name: RuleName): fc.Arbitrary<number> {
  const { least, most, default: usual } = RULES[name];
  const from = Math.max(least, most / 1e5);
  return fc.oneof(
    { weight: 2, arbitrary: fc.constant(usual) },
    { weight: 1, arbitrary: fc.constantFrom(least, most) },
    { weight: 5, arbitrary: fc.integer({ min: 0, max: 1_000_000 }).map((n) => from * (most / from) ** (n / 1_000_000)) },
  );
}

/** Rules for a level: all of them, wherever a level file may have them. */
export const someRules: fc.Arbitrary<OwnRules> = fc.record(
  Object.fromEntries(RULE_NAMES.map((name) => [name, someValue(name)])) as { [name in RuleName]: fc.Arbitrary<number> },
);
