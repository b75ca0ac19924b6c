import { closestName } from '../schema/basics/index.ts';

/** ` (did you mean X?)`, or an empty text if no candidate is close. */
export function didYouMean(word: string, candidates: readonly string[]): string {
  const best = closestName(word, candidates);
  return best === null ? '' : ` (did you mean ${best}?)`;
}
