import {
  fieldsOf,
  isRequired,
  KINDS,
  kindOfList,
  type LevelFile,
  LIMITS,
  levelSchema,
  OBJECT_KINDS,
  OBJECT_LISTS,
  OBJECT_SCHEMAS,
  type ObjectKind,
  type ObjectList,
  RULE_NAMES,
  RULES,
  rulesSchema,
  SINGLE_KINDS,
  withIds,
} from '../../schema/index.ts';

/** Why a change was refused, for the user. */
export interface Refusal {
  readonly message: string;
  readonly hint: string;
}

export type Settled = { readonly ok: true; readonly file: LevelFile } | { readonly ok: false; readonly refusal: Refusal };

type Json = { [key: string]: unknown };
type Shape = { readonly [key: string]: { safeParse(value: unknown): { success: boolean } } };

/** The fields that an object of a file may have. */
interface Fields {
  readonly shape: Shape;
  /** The ranges of its numbers. */
  readonly limits: Readonly<Record<string, readonly [least: number, most: number]>>;
  /** Its required fields. */
  readonly required: readonly string[];
}

const { shape } = levelSchema;
const ID = /^[a-z0-9]{2,16}$/;

const LEVEL: Fields = { shape, limits: { range: [LIMITS.leastRadius, LIMITS.radius] }, required: [] };
const OF_RULES: Fields = {
  shape: rulesSchema.shape,
  limits: Object.fromEntries(RULE_NAMES.map((name) => [name, [RULES[name].least, RULES[name].most]])),
  required: [],
};
const RUN: Fields = { shape: shape.runs.unwrap().element.shape, limits: {}, required: [] };

function fieldsOfKind(kind: ObjectKind): Fields {
  const fields = fieldsOf(kind);
  return {
    shape: OBJECT_SCHEMAS[kind].shape,
    limits: Object.fromEntries(
      fields.flatMap(([name, field]) => (field.type === 'number' ? [[name, [field.least, field.most]]] : [])),
    ),
    required: fields.flatMap(([name, field]) => (isRequired(field) ? [name] : [])),
  };
}

const OF_KIND = Object.fromEntries(OBJECT_KINDS.map((kind) => [kind, fieldsOfKind(kind)])) as Readonly<
  Record<ObjectKind, Fields>
>;

const TEXT_LIMITS: Readonly<Record<string, number>> = { description: 2000 };
const NAME_LIMITS = { level: 120, run: 80 };

class Refused extends Error {
  constructor(readonly refusal: Refusal) {
    super(refusal.message);
  }
}

const refuse = (message: string, hint: string): never => {
  throw new Refused({ message, hint });
};

/** Cuts a text to a length without splitting a surrogate pair. */
function cut(text: string, most: number): string {
  if (text.length <= most) return text;
  const last = text.charCodeAt(most - 1);
  return text.slice(0, last >= 0xd800 && last < 0xdc00 ? most - 1 : most);
}

/** The settled value of a field; undefined omits it. */
function settleField(key: string, value: unknown, fields: Fields, what: string): unknown {
  if (value === undefined || key.startsWith('x-')) return value;
  if (!Object.hasOwn(fields.shape, key)) refuse(`${what} has no ${key}`, 'Custom keys begin with x-.');
  if (typeof value === 'number' && Object.hasOwn(fields.limits, key)) {
    if (Number.isNaN(value)) refuse(`${key} of ${what} would not be a number`, 'Type a number.');
    const [least, most] = fields.limits[key];
    // + 0 turns -0 into 0, which is how a file stores it
    return Math.min(most, Math.max(least, value)) + 0;
  }
  if (typeof value === 'string' && Object.hasOwn(TEXT_LIMITS, key)) return cut(value, TEXT_LIMITS[key]);
  if (key === 'id') return typeof value === 'string' && ID.test(value) ? value : undefined;
  if (!fields.shape[key].safeParse(value).success)
    refuse(`${key} of ${what} can't be ${JSON.stringify(value)}`, 'Give it another value.');
  return value;
}

/**
 * @param old an object that is settled: fields equal in both are skipped
 * @returns the same object if nothing changes
 */
function settleFields<T extends object>(value: T, fields: Fields, what: string, old?: object): T {
  let changed: Json | null = null;
  const before = old as Json | undefined;
  for (const key of Object.keys(value)) {
    const field = (value as Json)[key];
    if (before !== undefined && field !== undefined && Object.is(before[key], field)) continue;
    const settled = settleField(key, field, fields, what);
    if (field !== undefined && Object.is(settled, field)) continue;
    changed ??= { ...value } as Json;
    if (settled === undefined) delete changed[key];
    else changed[key] = settled;
  }
  for (const key of fields.required) {
    if (!Object.hasOwn(changed ?? value, key)) refuse(`${what} has no ${key}`, `Give it a ${key}.`);
  }
  return (changed as T | null) ?? value;
}

/** Returns the same list if none of its entries changes. */
function settleEach<T>(
  list: readonly T[],
  old: readonly T[] | undefined,
  settle: (entry: T, old: T | undefined) => T,
): readonly T[] {
  if (list === old) return list;
  let changed: T[] | null = null;
  for (let i = 0; i < list.length; i++) {
    // unchanged entries are settled already
    if (old !== undefined && list[i] === old[i]) continue;
    const settled = settle(list[i], old?.[i]);
    if (settled === list[i]) continue;
    changed ??= [...list];
    changed[i] = settled;
  }
  return changed ?? list;
}

type RunFile = NonNullable<LevelFile['runs']>[number];

const tickOf = (tick: number): number => Math.min(LIMITS.tick, Math.max(0, Math.round(tick)));

function settleHolds(holds: RunFile['holds']): RunFile['holds'] {
  if (holds.length > LIMITS.holds) refuse(`a run can have ${LIMITS.holds} holds at most`, 'Delete some of them.');
  let isFine = true;
  for (const [press, release] of holds) {
    if (Number.isNaN(press + release)) refuse('a hold would not begin and end at a number', 'Type a whole number of ticks.');
    if (!Object.is(tickOf(press), press) || tickOf(release) !== release || release <= press) isFine = false;
  }
  if (isFine) return holds;
  const settled = holds.map(([press, release]): [number, number] => [tickOf(press), tickOf(release)]);
  return settled.filter(([press, release]) => release > press);
}

function settleName(name: unknown, most: number, what: string): string {
  if (typeof name !== 'string' || name === '') refuse(`${what} needs a name`, 'Type a name.');
  return cut(name as string, most);
}

function settleRun(value: RunFile): RunFile {
  const { name, holds, ...others } = value;
  const settled = { name: settleName(name, NAME_LIMITS.run, 'a run'), holds: settleHolds(holds) };
  const rest = settleFields(others, RUN, 'a run');
  return settled.name === name && settled.holds === holds && rest === others ? value : { ...rest, ...settled };
}

/** A copy in which an id that occurs twice stays with its first owner. */
function withoutSharedIds(file: LevelFile): LevelFile {
  const taken = new Set<string>();
  const settled = { ...file };
  const own = <T extends { id?: string | undefined }>(object: T): T => {
    if (object.id === undefined) return object;
    if (!taken.has(object.id)) {
      taken.add(object.id);
      return object;
    }
    const { id: _, ...rest } = object;
    return rest as T;
  };
  for (const list of OBJECT_LISTS) if (file[list] !== undefined) settled[list] = file[list].map(own) as never;
  return settled;
}

function settleIds(file: LevelFile, before: LevelFile | null): LevelFile {
  const same = (list: ObjectList) =>
    before !== null &&
    (file[list] === before[list] ||
      (file[list]?.length === before[list]?.length &&
        (file[list] ?? []).every((object, i) => object.id !== undefined && object.id === before[list]?.[i].id)));
  if (OBJECT_LISTS.every(same)) return file;
  return withIds(withoutSharedIds(file));
}

function settleTop(file: LevelFile, before: LevelFile | null): LevelFile {
  const lists: readonly string[] = [...OBJECT_LISTS, ...SINGLE_KINDS, 'rules', 'runs', 'name', 'version'];
  const own = Object.fromEntries(Object.entries(file).filter(([key]) => !lists.includes(key)));
  const settled: LevelFile = { ...file, ...settleFields(own, LEVEL, 'a level') };
  for (const key of Object.keys(settled))
    if (settled[key as keyof LevelFile] === undefined) delete settled[key as keyof LevelFile];
  settled.name = settleName(file.name, NAME_LIMITS.level, 'a level');
  if (file.version !== 1) refuse('a level has version 1', 'Leave the version as it is.');
  for (const kind of SINGLE_KINDS) {
    if (file[kind] !== before?.[kind])
      settled[kind] = settleFields<object>(file[kind], OF_KIND[kind], `the ${KINDS[kind].one}`) as never;
  }
  if (file.rules !== undefined && file.rules !== before?.rules) {
    if (typeof file.rules !== 'object' || file.rules === null || Array.isArray(file.rules))
      refuse(`rules of a level can't be ${JSON.stringify(file.rules)}`, 'Give an object of rule names and numbers.');
    settled.rules = settleFields(file.rules, OF_RULES, 'the rules', before?.rules);
  }
  for (const list of OBJECT_LISTS) {
    const objects = file[list];
    if (objects === undefined) continue;
    if (objects.length > LIMITS.objects) refuse(`a level can have ${LIMITS.objects} ${list} at most`, 'Delete some of them.');
    const fields = OF_KIND[kindOfList(list)];
    settled[list] = settleEach<object>(objects, before?.[list], (object, old) =>
      settleFields(object, fields, `one of the ${list}`, old),
    ) as never;
  }
  if (file.runs !== undefined && file.runs !== before?.runs) {
    if (file.runs.length > LIMITS.runs) refuse(`a level can have ${LIMITS.runs} runs at most`, 'Delete some of them.');
    settled.runs = settleEach(file.runs, before?.runs, (value) => settleRun(value)) as RunFile[];
    const names = settled.runs.map(({ name }) => name);
    const twice = names.find((name, i) => names.indexOf(name) !== i);
    if (twice !== undefined) refuse(`a run called ${JSON.stringify(twice)} already exists`, 'Choose another name.');
  }
  return settled;
}

/**
 * Makes a valid level of the result of a recipe: limits numbers to their ranges, cuts texts, rounds ticks, drops empty holds,
 * adds missing ids. What is not close to a valid level is refused. Everything shared with `before`, which is settled, is
 * skipped.
 */
export function settle(file: LevelFile, before: LevelFile | null): Settled {
  try {
    return { ok: true, file: settleIds(settleTop(file, before), before) };
  } catch (error) {
    if (error instanceof Refused) return { ok: false, refusal: error.refusal };
    throw error;
  }
}
