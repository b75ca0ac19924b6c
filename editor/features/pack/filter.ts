import { effectInWords } from '../../../check/pack/index.ts';
import type { Card } from './pack-model.ts';

/** Which cards are shown. */
export interface Filter {
  /** Words that must all occur in the name or the file name. */
  readonly text: string;
  /** The verdict; '' for any. */
  readonly verdict: string;
  /** The effect that the level calls for; '' for any. */
  readonly effect: string;
}

export const NO_FILTER: Filter = { text: '', verdict: '', effect: '' };

export const isFiltered = ({ text, verdict, effect }: Filter): boolean => text.trim() !== '' || verdict !== '' || effect !== '';

/** Whether a card passes. @param verdict that of the card */
export function passes(card: Card, verdict: string, filter: Filter): boolean {
  const name = `${card.entry?.name ?? ''} ${card.id}`.toLowerCase();
  const words = filter.text.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.every((word) => name.includes(word))) return false;
  if (filter.verdict !== '' && verdict !== filter.verdict) return false;
  return filter.effect === '' || card.facts?.effects.includes(filter.effect) === true;
}

/** The effects that some card has, for a choice: value and words. */
export function effectsOf(cards: readonly Card[]): readonly (readonly [value: string, words: string])[] {
  const names = new Set(cards.flatMap(({ facts }) => facts?.effects ?? []));
  return [...names].sort().map((name) => [name, effectInWords(name)] as const);
}
