import { type FolderTerms, type GameRule, type LevelFile, RULE_NAMES, RULES, type RuleName } from '../../../schema/index.ts';
import { fieldsOf } from './fields.ts';

/** The state of a rule in a level. */
export interface RuleValue {
  readonly name: RuleName;
  /** The effective value. */
  readonly value: number;
  /** Whether the level sets it. */
  readonly isOwn: boolean;
  /** The value that applies if the level doesn't set it. */
  readonly fallback: number;
  /** The configuration that sets the fallback; null: it is the game's default. */
  readonly from: string | null;
}

/** The label of a rule: `speed limit`. A rule that shares its name with a field of the level is called its strength. */
export function ruleLabel(name: RuleName): string {
  const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return fieldsOf('level').fields.some(({ key }) => key === name) ? `${words} strength` : words;
}

/** The state of all rules of a level, in the order of their table. */
export function ruleValues({ rules = {} }: Pick<LevelFile, 'rules'>, folder: FolderTerms): readonly RuleValue[] {
  return RULE_NAMES.map((name) => {
    const own = rules[name];
    const fallback = folder.rules[name] ?? RULES[name].default;
    const from = folder.rules[name] === undefined ? null : folder.file;
    return { name, value: own ?? fallback, isOwn: own !== undefined, fallback, from };
  });
}

/** Where a rule's value comes from; null if it is the game's default. */
export function originOf({ name, isOwn, fallback, from }: RuleValue): string | null {
  const game = `the game's default is ${RULES[name].default}`;
  if (!isOwn) return from === null ? null : `From ${from}; ${game}.`;
  return from === null ? `Set by this level; ${game}.` : `Set by this level; ${from} has ${fallback}.`;
}

/** The range of a rule: its ends, and the game's default, which needs room on both sides. */
type Range = Pick<GameRule, 'least' | 'most' | 'default'>;

/** the right end of a slider; the left one is 0 */
export const SLIDER_END = 1000;

/** the greatest exponent of a scale: above it, the smallest values would have no room */
const STEEPEST = 6;

/** The exponent of a scale. It puts the game's default in the middle; if the default is an end, the scale is linear. */
function steepnessOf({ least, most, default: middle }: Range): number {
  return Math.min(STEEPEST, Math.max(1, Math.log2((most - least) / (middle - least))));
}

/** The change per arrow key: a power of ten, at most a twentieth of the game's default. */
export const stepOf = ({ default: usual }: Range): number => 10 ** Math.floor(Math.log10(usual / 20));

/** The position of a value on its slider. */
export function positionOf(rule: Range, value: number): number {
  return SLIDER_END * ((value - rule.least) / (rule.most - rule.least)) ** (1 / steepnessOf(rule));
}

/** The value at a slider position, rounded to whole steps, large values to three digits. */
export function valueAt(rule: Range, position: number): number {
  const { least, most } = rule;
  const exact = least + (most - least) * (position / SLIDER_END) ** steepnessOf(rule);
  const digits = exact > 0 ? 10 ** (Math.floor(Math.log10(exact)) - 2) : 0;
  const grain = Math.max(stepOf(rule), digits);
  return within(rule, Math.round(exact / grain) * grain);
}

/** Limits a value to the range of its rule and removes the rounding errors of sums. */
export const within = ({ least, most }: Range, value: number): number =>
  Math.min(most, Math.max(least, Number(value.toFixed(6))));
