export { type Advice, type CheckCode, explainCodes } from './codes.ts';
export { accuracyInWords, closestInWords, effortInWords, holdsInWords, plural, termsInWords, termsReport } from './figures.ts';
export {
  bodyInWords,
  countMinerals,
  eventInWords,
  outcomeAsPredicate,
  outcomeInWords,
  type RunEnd,
  reasonInWords,
  VERDICT_MEANS,
} from './outcome.ts';
export { proposalInWords, proposalRunInWords, SIZE_MEANS } from './proposal.ts';
