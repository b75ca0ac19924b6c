import type { GameRule } from '../../../schema/index.ts';

/** What a rule can be slid over: its ends, and the game's own value, which is where a hand expects room on both sides. */
type Range = Pick<GameRule, 'least' | 'most' | 'default'>;

/** The right end of a slider; the left one is 0. */
export const SLIDER_END = 1000;

/** The steepest a scale gets: with more the least values would have no room. */
const STEEPEST = 6;

/** A scale is a power of the way along it, such that the game's own value is in the middle, or, where it is an end, evenly divided. */
function steepnessOf({ least, most, default: middle }: Range): number {
  return Math.min(STEEPEST, Math.max(1, Math.log2((most - least) / (middle - least))));
}

/** What an arrow key changes a rule by: a round number, a twentieth of the game's own value or less. */
export const stepOf = ({ default: usual }: Range): number => 10 ** Math.floor(Math.log10(usual / 20));

/** Where a value is on its slider. */
export function positionOf(rule: Range, value: number): number {
  return SLIDER_END * ((value - rule.least) / (rule.most - rule.least)) ** (1 / steepnessOf(rule));
}

/** The value at a place of the slider, rounded: to whole steps, of large values to three digits. */
export function valueAt(rule: Range, position: number): number {
  const { least, most } = rule;
  const exact = least + (most - least) * (position / SLIDER_END) ** steepnessOf(rule);
  const digits = exact > 0 ? 10 ** (Math.floor(Math.log10(exact)) - 2) : 0;
  const grain = Math.max(stepOf(rule), digits);
  return within(rule, Math.round(exact / grain) * grain);
}

/** A value within the limits of its rule, without what adding up small numbers leaves behind. */
export const within = ({ least, most }: Range, value: number): number =>
  Math.min(most, Math.max(least, Number(value.toFixed(6))));
