import { type LevelFile, type OwnRules, RULE_NAMES, RULES, type RuleName } from '../../schema/index.ts';

const withRules = (file: LevelFile, more: OwnRules): LevelFile =>
  Object.keys(more).length === 0 ? file : { ...file, rules: { ...more, ...file.rules } };

const pick = (names: readonly RuleName[], value: (name: RuleName) => number | undefined): OwnRules =>
  Object.fromEntries(names.map((name) => [name, value(name)]));

/** Rules that the folder sets otherwise than the game, and the level not at all. */
const decidedByFolder = ({ rules }: LevelFile, folder: OwnRules): RuleName[] =>
  RULE_NAMES.filter((name) => rules?.[name] === undefined && (folder[name] ?? RULES[name].default) !== RULES[name].default);

/** A level as it leaves its folder: the rules that it had from there are its own, so that it plays the same where there is no such folder. */
export const leavingFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => folder[name]),
  );

/** A level from where no folder set rules, as it plays the same in one that does: the game's own rules are its own there. */
export const enteringFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => RULES[name].default),
  );
