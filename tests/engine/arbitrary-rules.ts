import fc from 'fast-check';
import { type OwnRules, RULE_NAMES, RULES, type RuleName } from '../../schema/index.ts';

/** Any value of a rule: near the default, anywhere in the range, and its ends. */
function valueFor(name: RuleName): fc.Arbitrary<number> {
  const { default: usual, least, most } = RULES[name];
  const clamp = (value: number) => Math.min(most, Math.max(least, value));
  return fc.oneof(
    { weight: 4, arbitrary: fc.integer({ min: 50, max: 150 }).map((percent) => clamp((usual * percent) / 100)) },
    { weight: 2, arbitrary: fc.integer({ min: 0, max: 1000 }).map((k) => least + ((most - least) * k) / 1000) },
    { weight: 1, arbitrary: fc.constantFrom(least, most) },
  );
}

const values = Object.fromEntries(RULE_NAMES.map((name) => [name, valueFor(name)])) as {
  [name in RuleName]: fc.Arbitrary<number>;
};

/** Rules within their ranges, some of them defaults. */
export const arbitraryRules: fc.Arbitrary<OwnRules> = fc.record(values, { requiredKeys: [] });

/** Every combination of the smallest or largest value of each rule. */
export const CORNERS: readonly OwnRules[] = Array.from({ length: 2 ** RULE_NAMES.length }, (_, corner) =>
  Object.fromEntries(RULE_NAMES.map((name, i) => [name, RULES[name][(corner >> i) & 1 ? 'most' : 'least']])),
);
