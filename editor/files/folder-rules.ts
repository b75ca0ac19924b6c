import { type FolderRules, isSame, type ListResponse } from '../../schema/index.ts';

/** For levels in folders without a configuration. */
export const NO_FOLDER_RULES: FolderRules = { file: null, own: {}, problems: [] };

/** The folder's rules, which apply where a level sets none; none before there is a list. */
export const folderRulesIn = ({ list }: { readonly list: ListResponse | null }): FolderRules => list?.rules ?? NO_FOLDER_RULES;

/** A list whose rules are the same objects as before if they are equal, so that subscribers see no change. */
export function withKeptRules(list: ListResponse, before: ListResponse | null): ListResponse {
  const old = before?.rules;
  if (old === undefined || old === list.rules) return list;
  if (isSame(old, list.rules)) return { ...list, rules: old };
  return isSame(old.own, list.rules.own) ? { ...list, rules: { ...list.rules, own: old.own } } : list;
}
