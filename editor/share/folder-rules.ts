import { type LevelFile, type OwnRules, RULE_NAMES, RULES, type RuleName } from '../../schema/index.ts';

const withRules = (file: LevelFile, more: OwnRules): LevelFile =>
  Object.keys(more).length === 0 ? file : { ...file, rules: { ...more, ...file.rules } };

const pick = (names: readonly RuleName[], value: (name: RuleName) => number | undefined): OwnRules =>
  Object.fromEntries(names.map((name) => [name, value(name)]));

/** Rules that the folder changes from the game's defaults and that the level does not set. */
const decidedByFolder = ({ rules }: LevelFile, folder: OwnRules): RuleName[] =>
  RULE_NAMES.filter((name) => rules?.[name] === undefined && (folder[name] ?? RULES[name].default) !== RULES[name].default);

/** A level as it leaves its folder: it gets the folder's rules as its own, so that it plays the same elsewhere. */
export const leavingFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => folder[name]),
  );

/** A level as it enters a folder with rules: it gets the game's defaults as its own, so that it plays the same there. */
export const enteringFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => RULES[name].default),
  );
