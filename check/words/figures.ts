import { type Terms, TICK, unusualTerms } from '../../engine/basics/index.ts';
import { type OwnRules, ownRules } from '../../schema/basics/index.ts';
import type { Hold, TermsReport } from '../../schema/index.ts';
import type { Closest, Effort } from '../../solver/index.ts';

/** Formats a number with its noun: `1 level`, `2 levels`. */
export const plural = (count: number, one: string, many = `${one}s`): string => `${count} ${count === 1 ? one : many}`;

/** Formats effort: `12 runs, 3456 ticks`. */
export const effortInWords = ({ runs, ticks }: Effort): string => `${plural(runs, 'run')}, ${plural(ticks, 'tick')}`;

/**
 * Formats a closest approach: `41.7 px from the black hole at 3.22 s`.
 * @param pixels formats a length in px
 */
export const closestInWords = (
  { distance, tick }: Pick<Closest, 'distance' | 'tick'>,
  pixels = (length: number): string => `${length.toFixed(1)} px`,
): string => `${pixels(distance)} from the black hole at ${(tick * TICK).toFixed(2)} s`;

/** Formats holds as `--holds` takes them: `12-96,130-188`, or `none`. */
export const holdsInWords = (holds: readonly Hold[]): string =>
  holds.length === 0 ? 'none' : holds.map(([press, release]) => `${press}-${release}`).join(',');

/**
 * Under which terms something is said about a level, as every report has it.
 * @param case the compiled level; of a file that is not a valid level, the terms and in place of the level the rules of its folder
 * @returns plain data; of the rules only those that have another value than in the original game
 */
export function termsReport({
  terms: { accuracy, maxTime, maxWork },
  level: { rules = {} },
}: {
  readonly terms: Terms;
  readonly level: { readonly rules?: OwnRules | undefined };
}): TermsReport {
  return {
    accuracy: accuracy.name,
    maxTime,
    maxWork,
    rules: ownRules(rules, {}).rules ?? {},
  };
}

/**
 * The terms that a report holds under, in words, as far as they are not the usual ones: `at arcade, at most 120 s`.
 * @param terms the terms; rules are not said
 * @returns '' under the usual terms
 */
export function termsInWords(terms: Terms): string {
  const { accuracy } = unusual(terms);
  return [...(accuracy === undefined ? [] : [`at ${accuracy}`]), ...limitsInWords(terms)].join(', ');
}

/** The name of the accuracy, and limits that are not the usual ones: `precise, at most 120 s`. */
export const accuracyInWords = (terms: Terms): string => [terms.accuracy.name, ...limitsInWords(terms)].join(', ');

const unusual = (terms: Terms) => unusualTerms({ ...terms, accuracy: terms.accuracy.name });

function limitsInWords(terms: Terms): string[] {
  const { maxTime, maxWork } = unusual(terms);
  return [
    ...(maxTime === undefined ? [] : [`at most ${maxTime} s`]),
    ...(maxWork === undefined ? [] : [`at most ${maxWork} pieces of motion`]),
  ];
}
