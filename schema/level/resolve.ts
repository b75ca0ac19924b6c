import {
  ALLOWABLE_CODES,
  type Allowed,
  DEFAULT_RULES,
  type Level,
  type OwnRules,
  ownRules,
  RULE_NAMES,
  type RuleName,
} from '../basics/index.ts';
import { LEVEL_SHAPE, type LevelFile, type Shape } from './shape.ts';

type Written = Readonly<Record<string, unknown>>;

type Entries = readonly (readonly [string, Shape])[];

/** The keys of a level, in their order, with those of its objects: they are the same for all levels. */
const KEYS: readonly { readonly key: string; readonly shape: Shape; readonly entries: Entries }[] = Object.entries<Shape>(
  LEVEL_SHAPE.keys,
).map(([key, shape]) => ({ key, shape, entries: Object.entries((shape.each ?? shape).keys ?? {}) }));

/** Fills in what a value of a shape leaves out. What the shape does not know is left away. */
function filled(value: unknown, { each }: Shape, entries: Entries): unknown {
  // + 0 turns -0 into 0: formatLevel writes it as 0, and it must not give another start than 0
  if (typeof value === 'number') return value + 0;
  if (typeof value !== 'object' || value === null) return value;
  if (each === undefined) return filledObject(value as Written, entries);
  return (value as readonly Written[]).map((object) => filledObject(object, entries));
}

function filledObject(object: Written, keys: Entries): Written {
  const whole: Record<string, unknown> = {};
  for (const [key, { usual }] of keys) {
    const value = object[key] ?? usual;
    whole[key] = typeof value === 'number' ? value + 0 : value;
  }
  return whole;
}

/** What a level allows, without x- keys. */
const allowed = (allow: Allowed): Allowed =>
  Object.fromEntries(ALLOWABLE_CODES.flatMap((code) => (Object.hasOwn(allow, code) ? [[code, allow[code]]] : [])));

/**
 * Fills in every default that a level file leaves out. {@link readLevel} does so, too.
 *
 * @param file - the content of a valid file; it is not changed
 * @param folder - rules of the level's folder, which apply where the level has none of its own
 * @returns the complete level
 */
export function resolveLevel(file: LevelFile, folder: OwnRules = {}): Level {
  // key by key, in the order of a level: spreads and lists of entries take three times as long
  const level: Record<string, unknown> = {};
  for (const { key, shape, entries } of KEYS) {
    switch (key) {
      case '$schema':
      case 'version':
      case 'conflicts':
        break;
      case 'rules': {
        const { rules } = ownRules(file.rules ?? {}, folder);
        if (rules !== undefined) level.rules = rules;
        break;
      }
      case 'allow': {
        const { allow } = file;
        if (allow !== undefined && Object.keys(allow).some((code) => !code.startsWith('x-'))) level.allow = allowed(allow);
        break;
      }
      case 'runs':
        // without notes, which change nothing in play
        level.runs = (file.runs ?? []).map(({ name, holds }) => ({
          name,
          holds: holds.map(([press, release]) => [press + 0, release] as const),
        }));
        break;
      default:
        level[key] = filled((file as Written)[key] ?? shape.usual, shape, entries);
    }
  }
  return level as unknown as Level;
}

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
