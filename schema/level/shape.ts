import {
  ALLOWABLE_CODES,
  DEFAULT_RANGE,
  type Field,
  type FieldsOf,
  fieldsOf,
  KINDS,
  LEVEL_VERSION,
  LIMITS,
  LISTED_KINDS,
  type ListedKind,
  type ListOf,
  type ObjectKind,
  RULE_NAMES,
  type RunNote,
  SINGLE_KINDS,
  type SingleKind,
} from '../basics/index.ts';
import type { Json } from '../json/index.ts';
import { RULES } from './rules.ts';

/** What ends a line: nothing that a note may have. */
export const LINE_BREAK = /\r\n|[\n\r\v\f\u0085\u2028\u2029]/;

/** The text of a note: one line, without white space at its ends. */
export const NOTE_TEXT = /^[^\s\x85](?:[^\n-\r\x85\u2028\u2029]*[^\s\x85])?$/;

/**
 * Notes in the order of a canonical file: by tick, and those of one tick as they come.
 *
 * @param notes - in any order
 * @returns a new list
 */
export const notesInOrder = <T extends RunNote>(notes: readonly T[]): T[] => [...notes].sort((a, b) => a.tick - b.tick);

/** What a value in a level file must be. */
export interface Shape {
  /** The type of the value; missing where any value may stand. */
  readonly type?: 'number' | 'integer' | 'boolean' | 'string' | 'array' | 'object';
  /** Of a number its least value; of a text or a list its least length. */
  readonly least?: number;
  /** Of a number its largest value; of a text or a list its largest length. */
  readonly most?: number;
  /** The only value that may stand here. */
  readonly only?: unknown;
  /** Of a text: the only ones that may stand here. */
  readonly among?: readonly string[];
  /** Whether null may stand here, too. */
  readonly nullable?: true;
  /** A regular expression that a text must match. */
  readonly pattern?: string;
  /** The shape of every entry of a list. */
  readonly each?: Shape;
  /** The shapes of an object's values by key, in the order of a file. Keys that begin with x- may have any value. */
  readonly keys?: ShapesByKey;
  /** Whether the object around it may lack it. */
  readonly optional?: true;
  /** What it is where it is left out. */
  readonly usual?: unknown;
}

/** The shapes of an object's values. */
export type ShapesByKey = { readonly [key: string]: Shape };

export const number = (least: number, most: number) => ({ type: 'number', least, most }) as const;
export const whole = (least: number, most: number) => ({ type: 'integer', least, most }) as const;
export const text = (least?: number, most?: number, pattern?: RegExp) =>
  ({ type: 'string', least, most, pattern: pattern?.source }) as const;
export const listOf = <S extends Shape>(each: S, most: number) => ({ type: 'array', most, each }) as const;
const pairOf = <S extends Shape>(each: S) => ({ type: 'array', least: 2, most: 2, each }) as const;
export const object = <K extends ShapesByKey>(keys: K) => ({ type: 'object', keys }) as const;
export const flag = { type: 'boolean' } as const;
const any = {} as const;

export const oneOf = <const T extends string>(among: readonly T[]) => ({ type: 'string', among }) as const;
export const orNull = <S extends Shape>(shape: S) => ({ ...shape, nullable: true as const });

export const optional = <S extends Shape>(shape: S, usual?: unknown) => ({ ...shape, optional: true as const, usual });

/** The shapes of an object's values, made from its keys. */
function byKey<K extends string, S extends Shape>(keys: readonly K[], shapeOf: (key: K) => S) {
  return Object.fromEntries(keys.map((key) => [key, shapeOf(key)])) as { readonly [key in K]: S };
}

const ID = text(undefined, undefined, /^[a-z0-9]{2,16}$/);

function fieldShape(field: Field): Shape {
  const shape = field.type === 'number' ? number(field.least, field.most) : flag;
  return field.default === undefined ? shape : optional(shape, field.default);
}

/** The shape of a field, by its type in the table of kinds. */
type FieldShape<F> = (F extends { readonly type: 'number' } ? ReturnType<typeof number> : typeof flag) &
  (F extends { readonly default: unknown } ? { readonly optional: true } : unknown);
type ObjectShape<K extends ObjectKind> = {
  readonly type: 'object';
  readonly keys: (K extends ListedKind ? { readonly id: typeof ID & { readonly optional: true } } : unknown) & {
    readonly [F in keyof FieldsOf<K>]: FieldShape<FieldsOf<K>[F]>;
  };
};

function objectShape<K extends ObjectKind>(kind: K): ObjectShape<K> {
  const fields = Object.fromEntries(fieldsOf(kind).map(([name, field]) => [name, fieldShape(field)]));
  return object(KINDS[kind].list === null ? fields : { id: optional(ID, null), ...fields }) as unknown as ObjectShape<K>;
}

const singles = Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, objectShape(kind)])) as {
  readonly [K in SingleKind]: ObjectShape<K>;
};

const lists = Object.fromEntries(
  LISTED_KINDS.map((kind) => [KINDS[kind].list, optional(listOf(objectShape(kind) as Shape, LIMITS.objects), [])]),
) as { readonly [K in ListedKind as ListOf<K>]: { type: 'array'; most: number; each: ObjectShape<K>; optional: true } };

const tick = whole(0, LIMITS.tick);

const run = object({
  name: text(1, 80),
  holds: listOf(pairOf(tick), LIMITS.holds),
  notes: optional(listOf(object({ tick, text: text(1, LIMITS.note, NOTE_TEXT) }), LIMITS.notes)),
});

const conflict = object({
  what: text(),
  key: text(1),
  base: optional(any),
  ours: optional(any),
  theirs: optional(any),
});

/** The shape of the rules of a level or a folder. */
export const RULES_SHAPE = object(byKey(RULE_NAMES, (name) => optional(number(RULES[name].least, RULES[name].most))));

const allow = object(byKey(ALLOWABLE_CODES, () => optional(text(1, LIMITS.reason, /\S/))));

/**
 * The shape of a level file, without words. Both readers of levels use it, that for authors and that for games; the zod schema
 * and the JSON Schema are made of it.
 */
export const LEVEL_SHAPE = object({
  $schema: optional(text()),
  version: { type: 'number', only: LEVEL_VERSION } as const,
  conflicts: optional(listOf(conflict, LIMITS.conflicts)),
  name: text(1, 120),
  description: optional(text(undefined, 2000), ''),
  ...singles,
  range: optional(number(LIMITS.leastRadius, LIMITS.radius), DEFAULT_RANGE),
  recoil: optional(flag, false),
  rules: optional(RULES_SHAPE),
  allow: optional(allow),
  ...lists,
  runs: optional(listOf(run, LIMITS.runs), []),
});

/** What a value of a shape is. */
export type ValueOf<S> = S extends { readonly nullable: true } ? BareValueOf<S> | null : BareValueOf<S>;
type BareValueOf<S> = S extends { readonly only: infer V }
  ? V
  : S extends { readonly among: readonly (infer V)[] }
    ? V
    : S extends { readonly type: 'number' | 'integer' }
      ? number
      : S extends { readonly type: 'boolean' }
        ? boolean
        : S extends { readonly type: 'string' }
          ? string
          : S extends { readonly least: 2; readonly each: infer E }
            ? [ValueOf<E>, ValueOf<E>]
            : S extends { readonly each: infer E }
              ? ValueOf<E>[]
              : S extends { readonly keys: infer K }
                ? ObjectOf<K>
                : unknown;
type OptionalIn<K> = { [key in keyof K]: K[key] extends { readonly optional: true } ? key : never }[keyof K];
type ObjectOf<K> = Flat<
  { -readonly [key in Exclude<keyof K, OptionalIn<K>>]: ValueOf<K[key]> } & {
    -readonly [key in OptionalIn<K>]?: ValueOf<K[key]> | undefined;
  }
>;
type Flat<T> = { [key in keyof T]: T[key] };

/** The content of a level file: what may be left out may be missing. */
export type LevelFile = ValueOf<typeof LEVEL_SHAPE>;

/** The shape of an object of a kind in a level file. */
export function shapeOfObject<K extends ObjectKind>(kind: K): ObjectShape<K> {
  const shape: Shape = (LEVEL_SHAPE.keys as ShapesByKey)[KINDS[kind].list ?? kind];
  return (shape.each ?? shape) as unknown as ObjectShape<K>;
}

/** The objects of a kind in a level file, as they are written. */
export function objectsOfFile(file: LevelFile, kind: ObjectKind): readonly Json[] {
  const { list } = KINDS[kind];
  const value = (file as unknown as Json)[list ?? kind];
  return list === null ? [value as Json] : ((value ?? []) as readonly Json[]);
}

/** An entry of `conflicts` in a level file: a property that two merged versions changed in different ways. */
export type FileConflict = NonNullable<LevelFile['conflicts']>[number];

/**
 * The shape of a level file as a table without words: types, limits, and the values that `resolveLevel` fills in.
 *
 * @returns the source of a module
 */
export function formatLevelShape(): string {
  const table = JSON.stringify(LEVEL_SHAPE, null, 1).replace(/"(\w+|\$schema)":/g, '$1:');
  return `/** The shape of a level file. */\nexport const LEVEL_SHAPE = ${table};\n`;
}
