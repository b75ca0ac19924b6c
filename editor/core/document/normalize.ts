import {
  fieldsOf,
  isRequired,
  KINDS,
  kindOfList,
  type LevelFile,
  LIMITS,
  LINE_BREAK,
  OBJECT_KINDS,
  OBJECT_LISTS,
  type ObjectKind,
  type ObjectList,
  RULE_NAMES,
  RULES,
  SINGLE_KINDS,
  withIds,
} from '../../../schema/index.ts';
import { fits, LEVEL_SHAPE, RULES_SHAPE, type Shape, shapeOfObject } from '../../../schema/level/index.ts';

/** Why a change was refused, for the user. */
export interface Refusal {
  readonly message: string;
  readonly hint: string;
}

type Normalized = { readonly ok: true; readonly file: LevelFile } | { readonly ok: false; readonly refusal: Refusal };

/**
 * Makes a valid level of the result of a recipe: limits numbers to their ranges, cuts texts, rounds ticks, drops empty holds,
 * adds missing ids. What is not close to a valid level is refused. Everything shared with `before`, which is normalized, is
 * skipped.
 */
export function normalize(file: LevelFile, before: LevelFile | null): Normalized {
  try {
    return { ok: true, file: normalizeIds(normalizeTop(file, before), before) };
  } catch (error) {
    if (error instanceof Refused) return { ok: false, refusal: error.refusal };
    throw error;
  }
}

const { keys } = LEVEL_SHAPE;
const LEVEL: Fields = { keys, limits: { range: [LIMITS.leastRadius, LIMITS.radius] }, required: [] };
const OF_RULES: Fields = {
  keys: RULES_SHAPE.keys,
  limits: Object.fromEntries(RULE_NAMES.map((name) => [name, [RULES[name].least, RULES[name].most]])),
  required: [],
};
function fieldsOfKind(kind: ObjectKind): Fields {
  const fields = fieldsOf(kind);
  return {
    keys: shapeOfObject(kind).keys,
    limits: Object.fromEntries(
      fields.flatMap(([name, field]) => (field.type === 'number' ? [[name, [field.least, field.most]]] : [])),
    ),
    required: fields.flatMap(([name, field]) => (isRequired(field) ? [name] : [])),
  };
}

const OF_KIND = Object.fromEntries(OBJECT_KINDS.map((kind) => [kind, fieldsOfKind(kind)])) as Readonly<
  Record<ObjectKind, Fields>
>;

const LONGEST_LEVEL_NAME = 120;

/** Returns the same list if none of its entries changes. */
function normalizeEach<T>(
  list: readonly T[],
  old: readonly T[] | undefined,
  normalize: (entry: T, old: T | undefined) => T,
): readonly T[] {
  if (list === old) return list;
  let changed: T[] | null = null;
  for (let i = 0; i < list.length; i++) {
    // unchanged entries are normalized already
    if (old !== undefined && list[i] === old[i]) continue;
    const normalized = normalize(list[i], old?.[i]);
    if (normalized === list[i]) continue;
    changed ??= [...list];
    changed[i] = normalized;
  }
  return changed ?? list;
}

/** A copy in which an id that occurs twice stays with its first owner. */
function withoutSharedIds(file: LevelFile): LevelFile {
  const taken = new Set<string>();
  const normalized = { ...file };
  const own = <T extends { id?: string | undefined }>(object: T): T => {
    if (object.id === undefined) return object;
    if (!taken.has(object.id)) {
      taken.add(object.id);
      return object;
    }
    const { id: _, ...rest } = object;
    return rest as T;
  };
  for (const list of OBJECT_LISTS) if (file[list] !== undefined) normalized[list] = file[list].map(own) as never;
  return normalized;
}

function normalizeIds(file: LevelFile, before: LevelFile | null): LevelFile {
  const same = (list: ObjectList) =>
    before !== null &&
    (file[list] === before[list] ||
      (file[list]?.length === before[list]?.length &&
        (file[list] ?? []).every((object, i) => object.id !== undefined && object.id === before[list]?.[i].id)));
  if (OBJECT_LISTS.every(same)) return file;
  return withIds(withoutSharedIds(file));
}

function normalizeTop(file: LevelFile, before: LevelFile | null): LevelFile {
  const lists: readonly string[] = [...OBJECT_LISTS, ...SINGLE_KINDS, 'rules', 'runs', 'name', 'version'];
  const own = Object.fromEntries(Object.entries(file).filter(([key]) => !lists.includes(key)));
  const normalized: LevelFile = { ...file, ...normalizeFields(own, LEVEL, 'a level') };
  for (const key of Object.keys(normalized))
    if (normalized[key as keyof LevelFile] === undefined) delete normalized[key as keyof LevelFile];
  normalized.name = normalizeName(file.name, LONGEST_LEVEL_NAME, 'a level');
  if (file.version !== 1) refuse('a level has version 1', 'Leave the version as it is.');
  for (const kind of SINGLE_KINDS) {
    if (file[kind] !== before?.[kind])
      normalized[kind] = normalizeFields<object>(file[kind], OF_KIND[kind], `the ${KINDS[kind].one}`) as never;
  }
  if (file.rules !== undefined && file.rules !== before?.rules) {
    if (typeof file.rules !== 'object' || file.rules === null || Array.isArray(file.rules))
      refuse(`rules of a level can't be ${JSON.stringify(file.rules)}`, 'Give an object of rule names and numbers.');
    normalized.rules = normalizeFields(file.rules, OF_RULES, 'the rules', before?.rules);
  }
  for (const list of OBJECT_LISTS) {
    const objects = file[list];
    if (objects === undefined) continue;
    if (objects.length > LIMITS.objects) refuse(`a level can have ${LIMITS.objects} ${list} at most`, 'Delete some of them.');
    const fields = OF_KIND[kindOfList(list)];
    normalized[list] = normalizeEach<object>(objects, before?.[list], (object, old) =>
      normalizeFields(object, fields, `one of the ${list}`, old),
    ) as never;
  }
  if (file.runs !== undefined && file.runs !== before?.runs) {
    if (file.runs.length > LIMITS.runs) refuse(`a level can have ${LIMITS.runs} runs at most`, 'Delete some of them.');
    normalized.runs = normalizeEach(file.runs, before?.runs, (value) => normalizeRun(value)) as RunFile[];
    const names = normalized.runs.map(({ name }) => name);
    const twice = names.find((name, i) => names.indexOf(name) !== i);
    if (twice !== undefined) refuse(`a run called ${JSON.stringify(twice)} already exists`, 'Choose another name.');
  }
  return normalized;
}

const { keys: ofRun } = keys.runs.each;
const RUN: Fields = { keys: ofRun, limits: {}, required: [] };
const NOTE: Fields = { keys: ofRun.notes.each.keys, limits: {}, required: ['tick', 'text'] };

const LONGEST_RUN_NAME = 80;

type RunFile = NonNullable<LevelFile['runs']>[number];
type Notes = RunFile['notes'];

const tickOf = (tick: number): number => Math.min(LIMITS.tick, Math.max(0, Math.round(tick)));

function normalizeHolds(holds: RunFile['holds']): RunFile['holds'] {
  if (holds.length > LIMITS.holds) refuse(`a run can have ${LIMITS.holds} holds at most`, 'Delete some of them.');
  let isFine = true;
  for (const [press, release] of holds) {
    if (Number.isNaN(press + release)) refuse('a hold would not begin and end at a number', 'Type a whole number of ticks.');
    if (!Object.is(tickOf(press), press) || tickOf(release) !== release || release <= press) isFine = false;
  }
  if (isFine) return holds;
  const normalized = holds.map(([press, release]): [number, number] => [tickOf(press), tickOf(release)]);
  return normalized.filter(([press, release]) => release > press);
}

/** A text on one line, as a note has it; '' if nothing is left. */
function normalizeText(text: unknown): string {
  if (typeof text !== 'string') refuse(`a note can't say ${JSON.stringify(text)}`, 'Type a text.');
  const line = (text as string).split(LINE_BREAK).join(' ').trim();
  return cut(line, LIMITS.note).trim();
}

function normalizeNotes(notes: Notes): Notes {
  if (notes === undefined) return undefined;
  if (notes.length > LIMITS.notes) refuse(`a run can have ${LIMITS.notes} notes at most`, 'Delete some of them.');
  let isFine = true;
  const normalized = notes.map((note) => {
    if (Number.isNaN(note.tick)) refuse('a note would not be at a number', 'Type a whole number of ticks.');
    const [tick, text] = [tickOf(note.tick), normalizeText(note.text)];
    const now = normalizeFields(
      Object.is(tick, note.tick) && text === note.text ? note : { ...note, tick, text },
      NOTE,
      'a note',
    );
    if (now !== note) isFine = false;
    return now;
  });
  if (isFine) return notes;
  const left = normalized.filter(({ text }) => text !== '');
  return left.length === 0 ? undefined : left;
}

/** A name that is not empty and not too long. */
function normalizeName(name: unknown, most: number, what: string): string {
  if (typeof name !== 'string' || name === '') refuse(`${what} needs a name`, 'Type a name.');
  return cut(name as string, most);
}

/** A valid run, the same object if it is one. */
function normalizeRun(value: RunFile): RunFile {
  const { name, holds, notes, ...others } = value;
  const normalized = { name: normalizeName(name, LONGEST_RUN_NAME, 'a run'), holds: normalizeHolds(holds) };
  const noted = normalizeNotes(notes);
  const rest = normalizeFields(others, RUN, 'a run');
  const isSame = normalized.name === name && normalized.holds === holds && noted === notes && rest === others;
  return isSame ? value : { ...normalized, ...(noted === undefined ? {} : { notes: noted }), ...rest };
}

type Json = { [key: string]: unknown };

/** The fields that an object of a file may have. */
interface Fields {
  readonly keys: { readonly [key: string]: Shape };
  /** The ranges of its numbers. */
  readonly limits: Readonly<Record<string, readonly [least: number, most: number]>>;
  /** Its required fields. */
  readonly required: readonly string[];
}

const ID = /^[a-z0-9]{2,16}$/;

const TEXT_LIMITS: Readonly<Record<string, number>> = { description: 2000 };

/** Thrown where a change is refused. */
class Refused extends Error {
  constructor(readonly refusal: Refusal) {
    super(refusal.message);
  }
}

/** Refuses a change. */
const refuse = (message: string, hint: string): never => {
  throw new Refused({ message, hint });
};

/** Cuts a text to a length without splitting a surrogate pair. */
function cut(text: string, most: number): string {
  if (text.length <= most) return text;
  const last = text.charCodeAt(most - 1);
  return text.slice(0, last >= 0xd800 && last < 0xdc00 ? most - 1 : most);
}

/** The normalized value of a field; undefined omits it. */
function normalizeField(key: string, value: unknown, fields: Fields, what: string): unknown {
  if (value === undefined || key.startsWith('x-')) return value;
  if (!Object.hasOwn(fields.keys, key)) refuse(`${what} has no ${key}`, 'Custom keys begin with x-.');
  if (typeof value === 'number' && Object.hasOwn(fields.limits, key)) {
    if (Number.isNaN(value)) refuse(`${key} of ${what} would not be a number`, 'Type a number.');
    const [least, most] = fields.limits[key];
    // + 0 turns -0 into 0, which is how a file stores it
    return Math.min(most, Math.max(least, value)) + 0;
  }
  if (typeof value === 'string' && Object.hasOwn(TEXT_LIMITS, key)) return cut(value, TEXT_LIMITS[key]);
  if (key === 'id') return typeof value === 'string' && ID.test(value) ? value : undefined;
  if (!fits(value, fields.keys[key])) refuse(`${key} of ${what} can't be ${JSON.stringify(value)}`, 'Give it another value.');
  return value;
}

/**
 * @param old an object that is normalized: fields equal in both are skipped
 * @returns the same object if nothing changes
 */
function normalizeFields<T extends object>(value: T, fields: Fields, what: string, old?: object): T {
  let changed: Json | null = null;
  const before = old as Json | undefined;
  for (const key of Object.keys(value)) {
    const field = (value as Json)[key];
    if (before !== undefined && field !== undefined && Object.is(before[key], field)) continue;
    const normalized = normalizeField(key, field, fields, what);
    if (field !== undefined && Object.is(normalized, field)) continue;
    changed ??= { ...value } as Json;
    if (normalized === undefined) delete changed[key];
    else changed[key] = normalized;
  }
  for (const key of fields.required) {
    if (!Object.hasOwn(changed ?? value, key)) refuse(`${what} has no ${key}`, `Give it a ${key}.`);
  }
  return (changed as T | null) ?? value;
}
