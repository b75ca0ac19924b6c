export { accuracyNameOf } from '../../workers/index.ts';
export { createPageTerms, type PageTerms, type TermsStore } from './page-terms.ts';
export { termsAt, termsKey } from './terms-of.ts';
export { isOtherAccuracy, termsInWords } from './words.ts';
