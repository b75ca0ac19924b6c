import { DEFAULT_ACCURACY, DEFAULT_TERMS } from '../../../engine/index.ts';
import { type FolderTerms, isSame, type ListResponse } from '../../../schema/index.ts';

const { maxTime, maxWork, rules } = DEFAULT_TERMS;

/** For levels in folders without a configuration. */
export const NO_FOLDER_TERMS: FolderTerms = { file: null, accuracy: DEFAULT_ACCURACY, maxTime, maxWork, rules, problems: [] };

/** The terms under which the folder's levels are judged; the defaults before there is a list. */
export const folderTermsIn = ({ list }: { readonly list: ListResponse | null }): FolderTerms => list?.terms ?? NO_FOLDER_TERMS;

/** A list whose terms are the same objects as before if they are equal, so that subscribers see no change. */
export function withKeptTerms(list: ListResponse, before: ListResponse | null): ListResponse {
  const old = before?.terms;
  if (old === undefined || old === list.terms) return list;
  if (isSame(old, list.terms)) return { ...list, terms: old };
  return isSame(old.rules, list.terms.rules) ? { ...list, terms: { ...list.terms, rules: old.rules } } : list;
}
