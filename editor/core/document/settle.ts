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
} from '../../../schema/index.ts';
import { type Fields, type Refusal, Refused, refuse, settleFields } from './settle-fields.ts';
import { type RunFile, settleName, settleRun } from './settle-run.ts';

export type { Refusal };

export type Settled = { readonly ok: true; readonly file: LevelFile } | { readonly ok: false; readonly refusal: Refusal };

const { shape } = levelSchema;
const LEVEL: Fields = { shape, limits: { range: [LIMITS.leastRadius, LIMITS.radius] }, required: [] };
const OF_RULES: Fields = {
  shape: rulesSchema.shape,
  limits: Object.fromEntries(RULE_NAMES.map((name) => [name, [RULES[name].least, RULES[name].most]])),
  required: [],
};
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

const LONGEST_NAME = 120;

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
  settled.name = settleName(file.name, LONGEST_NAME, 'a level');
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
