import type { PageTerms } from './page-terms.ts';

/** Whether the open level is shown at another accuracy than that of the folder. */
export const isOtherAccuracy = ({ folder, shown }: PageTerms): boolean => folder.accuracy !== shown.accuracy;

/** At which accuracy the open level is shown: `precise`, or `at precise; gq check here: arcade`. */
export const termsInWords = (terms: PageTerms): string =>
  isOtherAccuracy(terms)
    ? `at ${terms.shown.accuracy.name}; gq check here: ${terms.folder.accuracy.name}`
    : terms.folder.accuracy.name;
