export { type Advice, type CheckCode, explainCodes } from './codes.ts';
export { closestInWords, effortInWords } from './effort.ts';
export { holdsInWords } from './holds.ts';
export {
  bodyInWords,
  countMinerals,
  outcomeAsPredicate,
  outcomeInWords,
  type RunEnd,
  reasonInWords,
} from './outcome.ts';
export { plural } from './plural.ts';
export { proposalInWords, proposalRunInWords, SIZE_MEANS } from './proposal.ts';
export { accuracyInWords, termsInWords, termsReport } from './terms.ts';
export { VERDICT_MEANS } from './verdict.ts';
