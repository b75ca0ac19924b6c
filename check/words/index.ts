export { type Advice, type CheckCode, explainCodes } from './codes.ts';
export { closestInWords, effortInWords, holdsInWords, plural } from './figures.ts';
export {
  bodyInWords,
  countMinerals,
  outcomeAsPredicate,
  outcomeInWords,
  type RunEnd,
  reasonInWords,
  VERDICT_MEANS,
} from './outcome.ts';
export { proposalInWords, proposalRunInWords, SIZE_MEANS } from './proposal.ts';
export { accuracyInWords, termsInWords, termsReport } from './terms.ts';
