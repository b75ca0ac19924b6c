import { ALLOWABLE_CODES } from './adjustable.ts';
import { type OwnRules, ownRules } from './default-rules.ts';
import { fieldsOf, KINDS, LISTED_KINDS, type ObjectKind, SINGLE_KINDS } from './kinds.ts';
import { type Allowed, DEFAULT_RANGE, type Level, type LevelFile } from './level.ts';

type Written = Readonly<Record<string, unknown>>;

/** Fills in what an object leaves out. */
function resolveObject(kind: ObjectKind, object: Written): Written {
  const resolved: Record<string, unknown> = KINDS[kind].list === null ? {} : { id: object.id ?? null };
  for (const [name, field] of fieldsOf(kind)) {
    const value = object[name] ?? field.default;
    // + 0 turns -0 into 0: formatLevel writes it as 0, and it must not give another start than 0
    resolved[name] = typeof value === 'number' ? value + 0 : value;
  }
  return resolved;
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
  const written = file as Readonly<Record<string, unknown>>;
  // key by key, in the order of a level: spreads and lists of entries take three times as long
  const level: Record<string, unknown> = { name: file.name, description: file.description ?? '' };
  for (const kind of SINGLE_KINDS) level[kind] = resolveObject(kind, file[kind]);
  level.range = file.range ?? DEFAULT_RANGE;
  level.recoil = file.recoil ?? false;
  const { rules } = ownRules(file.rules ?? {}, folder);
  if (rules !== undefined) level.rules = rules;
  const { allow } = file;
  if (allow !== undefined && Object.keys(allow).some((code) => !code.startsWith('x-'))) level.allow = allowed(allow);
  for (const kind of LISTED_KINDS) {
    const list = KINDS[kind].list as string;
    level[list] = ((written[list] ?? []) as readonly Written[]).map((object) => resolveObject(kind, object));
  }
  level.runs = (file.runs ?? []).map((run) => ({
    name: run.name,
    holds: run.holds.map(([press, release]) => [press + 0, release] as const),
  }));
  return level as unknown as Level;
}
