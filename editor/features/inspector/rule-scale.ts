import type { GameRule } from '../../../schema/index.ts';

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
