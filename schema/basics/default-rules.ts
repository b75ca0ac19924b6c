// Only the numbers: the table RULES has the words, which a game does not need.
const ORIGINAL = {
  pull: 39,
  recoil: 1,
  push: 20,
  alienPull: 8,
  alienSight: 150,
  speedLimit: 1000,
  boxWidth: 20,
  boxHeight: 32,
};

/** The name of a rule. */
export type RuleName = keyof typeof ORIGINAL;

/** A value for each rule. */
export type Rules = { readonly [name in RuleName]: number };

/** The original game's rules. */
export const DEFAULT_RULES: Rules = ORIGINAL;

/** The rules that have another value than in the original game. */
export type OwnRules = { readonly [name in RuleName]?: number };

/** The names of all rules, in the order in which they are listed. */
export const RULE_NAMES = /* @__PURE__ */ Object.keys(ORIGINAL) as readonly RuleName[];

/**
 * The rules of a level.
 *
 * @param level - a level, or anything with `rules`
 * @returns a value for each rule: the level's own, or the original game's
 */
export function rulesOf({ rules }: { readonly rules?: OwnRules | undefined }): Rules {
  if (rules === undefined) return DEFAULT_RULES;
  // written out: every check of a level needs them, and a loop over names takes ten times as long
  return {
    pull: rules.pull ?? ORIGINAL.pull,
    recoil: rules.recoil ?? ORIGINAL.recoil,
    push: rules.push ?? ORIGINAL.push,
    alienPull: rules.alienPull ?? ORIGINAL.alienPull,
    alienSight: rules.alienSight ?? ORIGINAL.alienSight,
    speedLimit: rules.speedLimit ?? ORIGINAL.speedLimit,
    boxWidth: rules.boxWidth ?? ORIGINAL.boxWidth,
    boxHeight: rules.boxHeight ?? ORIGINAL.boxHeight,
  };
}

/**
 * The rules of a level in a folder that differ from the original game's. A rule that repeats the original's value matters only
 * against its folder.
 *
 * @param rules - those that the level sets
 * @param folder - those that its folder sets
 * @returns what a level has as its `rules`; nothing when no rule differs
 */
export function ownRules(rules: OwnRules, folder: OwnRules): { readonly rules?: OwnRules } {
  const own: Partial<Record<RuleName, number>> = {};
  let count = 0;
  for (const name of RULE_NAMES) {
    const value = rules[name] ?? folder[name];
    if (value === undefined || value === DEFAULT_RULES[name]) continue;
    own[name] = value;
    count++;
  }
  return count === 0 ? {} : { rules: own };
}
