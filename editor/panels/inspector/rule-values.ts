import { type FolderRules, type LevelFile, RULE_NAMES, RULES, type RuleName } from '../../../schema/index.ts';
import { fieldsOf } from './fields.ts';

/** How a rule of a level stands. */
export interface RuleValue {
  readonly name: RuleName;
  /** What it is played by. */
  readonly value: number;
  /** Whether the level sets it. */
  readonly isOwn: boolean;
  /** What holds where the level doesn't set it. */
  readonly fallback: number;
  /** The configuration that sets the fallback; null: it is the game's own. */
  readonly from: string | null;
}

/** How a rule is called: `speed limit`. One that a field of the level is called, too, is the strength of that. */
export function ruleLabel(name: RuleName): string {
  const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return fieldsOf('level').fields.some(({ key }) => key === name) ? `${words} strength` : words;
}

/** All rules of a level as they stand, in the order of their table. */
export function ruleValues({ rules = {} }: Pick<LevelFile, 'rules'>, folder: FolderRules): readonly RuleValue[] {
  return RULE_NAMES.map((name) => {
    const own = rules[name];
    const fallback = folder.own[name] ?? RULES[name].default;
    const from = folder.own[name] === undefined ? null : folder.file;
    return { name, value: own ?? fallback, isOwn: own !== undefined, fallback, from };
  });
}

/** Where a rule's value comes from, where that is not the game. */
export function originOf({ name, isOwn, fallback, from }: RuleValue): string | null {
  const game = `the game's own is ${RULES[name].default}`;
  if (!isOwn) return from === null ? null : `From ${from}; ${game}.`;
  return from === null ? `Set by this level; ${game}.` : `Set by this level; ${from} has ${fallback}.`;
}
