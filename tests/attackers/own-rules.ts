import { type Level, type OwnRules, RULE_NAMES, RULES, type RuleName, rulesOf } from '../../schema/index.ts';

const within = (name: RuleName, value: number): number => Math.min(RULES[name].most, Math.max(RULES[name].least, value));

/** Rules of its own for a level: half of them the original's, some very different. */
export function ownRules(random: () => number): OwnRules {
  const value = (name: RuleName): number => {
    const kind = random();
    const spread = kind < 0.5 ? 0 : kind < 0.9 ? 1 : 6;
    return within(name, RULES[name].default * 2 ** (spread * (2 * random() - 1)));
  };
  return Object.fromEntries(RULE_NAMES.map((name) => [name, value(name)]));
}

/** The level with one of its rules changed, often by a thousandth at most. */
export function otherRules(level: Level, random: () => number): Level {
  const name = RULE_NAMES[Math.floor(random() * RULE_NAMES.length)];
  const factors = [0.999, 1.001, 0.999, 1.001, 0.99, 1.01, 0.9, 1.1, 0.5, 2];
  const value = rulesOf(level)[name] * factors[Math.floor(random() * factors.length)];
  return { ...level, rules: { ...level.rules, [name]: within(name, value) } };
}
