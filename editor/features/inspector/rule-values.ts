import { type FolderTerms, type LevelFile, RULE_NAMES, RULES, type RuleName } from '../../../schema/index.ts';
import { fieldsOf } from './fields.ts';

/** The state of a rule in a level. */
export interface RuleValue {
  readonly name: RuleName;
  /** The effective value. */
  readonly value: number;
  /** Whether the level sets it. */
  readonly isOwn: boolean;
  /** The value that applies if the level doesn't set it. */
  readonly fallback: number;
  /** The configuration that sets the fallback; null: it is the game's default. */
  readonly from: string | null;
}

/** The label of a rule: `speed limit`. A rule that shares its name with a field of the level is called its strength. */
export function ruleLabel(name: RuleName): string {
  const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return fieldsOf('level').fields.some(({ key }) => key === name) ? `${words} strength` : words;
}

/** The state of all rules of a level, in the order of their table. */
export function ruleValues({ rules = {} }: Pick<LevelFile, 'rules'>, folder: FolderTerms): readonly RuleValue[] {
  return RULE_NAMES.map((name) => {
    const own = rules[name];
    const fallback = folder.rules[name] ?? RULES[name].default;
    const from = folder.rules[name] === undefined ? null : folder.file;
    return { name, value: own ?? fallback, isOwn: own !== undefined, fallback, from };
  });
}

/** Where a rule's value comes from; null if it is the game's default. */
export function originOf({ name, isOwn, fallback, from }: RuleValue): string | null {
  const game = `the game's default is ${RULES[name].default}`;
  if (!isOwn) return from === null ? null : `From ${from}; ${game}.`;
  return from === null ? `Set by this level; ${game}.` : `Set by this level; ${from} has ${fallback}.`;
}
