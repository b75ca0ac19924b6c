import { closestName } from '../schema/index.ts';

/** ` (did you mean X?)`, or nothing when none of the candidates is close. */
export function didYouMean(word: string, candidates: readonly string[]): string {
  const best = closestName(word, candidates);
  return best === null ? '' : ` (did you mean ${best}?)`;
}
