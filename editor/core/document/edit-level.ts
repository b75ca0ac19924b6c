import { type LevelFile, RULE_NAMES, type RuleName } from '../../../schema/index.ts';
import type { Recipe } from './edited-level.ts';

/** Properties of the level itself that can be edited. */
export type LevelProperty = 'name' | 'description' | 'range' | 'recoil';

/** Sets a property of the level; undefined removes it, so that the default applies. */
export function setLevelProperty<P extends LevelProperty>(property: P, value: LevelFile[P]): Recipe {
  return (draft) => {
    if (value === undefined) delete draft[property];
    else draft[property] = value;
  };
}

type RulesOfFile = NonNullable<LevelFile['rules']>;

/** Sets a rule of the level; undefined removes it, so that the folder's rule or the game's default applies. */
export const setRule =
  (name: RuleName, value: number | undefined): Recipe =>
  (draft) => {
    const { [name]: _, ...others } = (draft.rules ?? {}) as RulesOfFile;
    put(draft, value === undefined ? others : { ...others, [name]: value });
  };

/** Removes all rules of the level; custom keys beside them stay. */
export const resetRules: Recipe = (draft) => {
  const kept = Object.entries(draft.rules ?? {}).filter(([key]) => !(RULE_NAMES as readonly string[]).includes(key));
  put(draft, Object.fromEntries(kept) as RulesOfFile);
};

function put(draft: LevelFile, rules: RulesOfFile): void {
  if (Object.keys(rules).length === 0) delete draft.rules;
  else draft.rules = rules;
}
