import { DEFAULT_RULES, type OwnRules, RULE_NAMES, type RuleName } from '../basics/default-rules.ts';
import type { LevelFile } from './shape.ts';

const withRules = (file: LevelFile, more: OwnRules): LevelFile =>
  Object.keys(more).length === 0 ? file : { ...file, rules: { ...more, ...file.rules } };

const pick = (names: readonly RuleName[], value: (name: RuleName) => number | undefined): OwnRules =>
  Object.fromEntries(names.map((name) => [name, value(name)]));

/** Rules that the folder changes from the game's defaults and that the level does not set. */
const decidedByFolder = ({ rules }: LevelFile, folder: OwnRules): RuleName[] =>
  RULE_NAMES.filter((name) => rules?.[name] === undefined && (folder[name] ?? DEFAULT_RULES[name]) !== DEFAULT_RULES[name]);

/**
 * A level as it leaves its folder: it gets the folder's rules as its own, so that it plays the same elsewhere.
 *
 * @param file the level file
 * @param folder the rules of its folder, from `gq.config.json`
 * @returns the level file itself if the folder's rules change nothing for it
 */
export const leavingFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => folder[name]),
  );

/**
 * A level as it enters a folder with rules: it gets the game's defaults as its own, so that it plays the same there.
 *
 * @param file the level file
 * @param folder the rules of the folder, from `gq.config.json`
 * @returns the level file itself if the folder's rules change nothing for it
 */
export const enteringFolder = (file: LevelFile, folder: OwnRules): LevelFile =>
  withRules(
    file,
    pick(decidedByFolder(file, folder), (name) => DEFAULT_RULES[name]),
  );
