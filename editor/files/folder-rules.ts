import type { FolderRules, ListResponse } from '../../schema/index.ts';
import { isSame } from '../document/index.ts';

/** Of levels that are in no folder with a configuration. */
export const NO_FOLDER_RULES: FolderRules = { file: null, own: {}, problems: [] };

/** The rules that hold for the levels of a list where they have none of their own; none before there is a list. */
export const folderRulesIn = ({ list }: { readonly list: ListResponse | null }): FolderRules => list?.rules ?? NO_FOLDER_RULES;

/** A list with its rules, which are the same objects as before where they say the same: who follows them sees that nothing has changed. */
export function withKeptRules(list: ListResponse, before: ListResponse | null): ListResponse {
  const old = before?.rules;
  if (old === undefined || old === list.rules) return list;
  if (isSame(old, list.rules)) return { ...list, rules: old };
  return isSame(old.own, list.rules.own) ? { ...list, rules: { ...list.rules, own: old.own } } : list;
}
