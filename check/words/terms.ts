import { type Terms, unusualTerms } from '../../engine/basics/index.ts';
import { type OwnRules, ownRules } from '../../schema/basics/index.ts';
import type { TermsReport } from '../../schema/index.ts';

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
