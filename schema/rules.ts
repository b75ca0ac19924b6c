import * as z from 'zod';

/** A number of the game that a level, or the configuration of a folder, may set. */
export interface GameRule {
  /** The unit, as text. */
  readonly unit: string;
  /** The original game's value. */
  readonly default: number;
  /** The smallest value allowed. */
  readonly least: number;
  /** The largest value allowed. */
  readonly most: number;
  /** What it does, for designers of levels. */
  readonly about: string;
}

/** The game's rules, in the order in which they are listed. */
export const RULES = {
  pull: {
    unit: 'px/s2',
    default: 39,
    least: 1,
    most: 1000,
    about: 'Pull of the gun next to its target; it falls evenly to 0 at the range.',
  },
  recoil: {
    unit: 'px2/s2',
    default: 1,
    least: 0,
    most: 1000,
    about: 'How the target of the gun is pulled towards her, where the level has recoil: this over its diameter.',
  },
  push: { unit: 'px/s2', default: 20, least: 1, most: 1000, about: 'Push of a repulsor away from its centre.' },
  alienPull: { unit: 'px/s2', default: 8, least: 0, most: 1000, about: 'How an alien that sees her accelerates towards her.' },
  alienSight: { unit: 'px', default: 150, least: 0, most: 10_000, about: 'How far an alien sees, from centre to centre.' },
  speedLimit: { unit: 'px/s', default: 1000, least: 10, most: 1000, about: 'Most that a velocity may have along each axis.' },
  boxWidth: {
    unit: 'px',
    default: 20,
    least: 1,
    most: 200,
    about: 'Width of her box, along the axis that points at the target.',
  },
  boxHeight: { unit: 'px', default: 32, least: 1, most: 200, about: 'Height of her box.' },
} as const satisfies Readonly<Record<string, GameRule>>;

/** The name of a rule. */
export type RuleName = keyof typeof RULES;

/** A value for each rule. */
export type Rules = { readonly [name in RuleName]: number };

/** The rules that have another value than in the original game. */
export type OwnRules = { readonly [name in RuleName]?: number };

/** The names of all rules, in the order in which they are listed. */
export const RULE_NAMES = Object.keys(RULES) as readonly RuleName[];

/** The original game's rules. */
export const DEFAULT_RULES = Object.fromEntries(RULE_NAMES.map((name) => [name, RULES[name].default])) as Rules;

/**
 * The rules of a level.
 *
 * @param level - a level, or anything with `rules`
 * @returns a value for each rule: the level's own, or the original game's
 */
export function rulesOf({ rules = {} }: { readonly rules?: OwnRules | undefined }): Rules {
  return Object.fromEntries(RULE_NAMES.map((name) => [name, rules[name] ?? RULES[name].default])) as Rules;
}

const number = (rule: GameRule) =>
  z.number().min(rule.least).max(rule.most).optional().describe(`${rule.about} In ${rule.unit}; ${rule.default} when left out.`);

/** The zod schema of `rules` in a level file or in the configuration of a folder. */
export const rulesSchema = z
  .strictObject(
    Object.fromEntries(RULE_NAMES.map((name) => [name, number(RULES[name])])) as {
      [name in RuleName]: z.ZodOptional<z.ZodNumber>;
    },
  )
  .describe('Numbers of the game that are another here; the game’s own when left out.');
