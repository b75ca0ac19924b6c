import * as z from 'zod';
import {
  ALLOWABLE_CODES,
  DEFAULT_RANGE,
  type FieldsOf,
  fieldsOf,
  KINDS,
  LISTED_KINDS,
  type ListedKind,
  type ListOf,
  OBJECT_KINDS,
  type ObjectKind,
  RULE_NAMES,
  type SingleKind,
} from './basics/index.ts';
import { LEVEL_SHAPE, type Shape as LevelShape, RULES } from './level/index.ts';

type Plain<F> = F extends { readonly type: 'number' } ? z.ZodNumber : z.ZodBoolean;
type FieldSchema<F> = F extends { readonly default: unknown } ? z.ZodOptional<Plain<F>> : Plain<F>;
type Id = { id: z.ZodOptional<z.ZodString> };
type Shape<K extends ObjectKind> = (K extends ListedKind ? Id : unknown) & {
  -readonly [F in keyof FieldsOf<K>]: FieldSchema<FieldsOf<K>[F]>;
};
type ObjectSchema<K extends ObjectKind> = z.ZodObject<{ [F in keyof Shape<K>]: Shape<K>[F] & z.core.$ZodType }, z.core.$strict>;

type Words = Readonly<Record<string, string>>;

/** What the keys of an object of a kind mean, by their path in the object; of the object itself under ''. */
const wordsOfKind = (kind: ObjectKind): Words => ({
  '': KINDS[kind].about,
  id: 'Short random name of this object: it stays while the object is moved and edited. Unique in the level; `gq fmt` adds missing ones.',
  ...Object.fromEntries(fieldsOf(kind).map(([name, { about }]) => [name, about])),
});

const RULE_WORDS: Words = {
  '': 'Numbers of the game that are another here; the game’s own when left out.',
  ...Object.fromEntries(
    RULE_NAMES.map((name) => [name, `${RULES[name].about} In ${RULES[name].unit}; ${RULES[name].default} when left out.`]),
  ),
};

/** The words of a part of a level, by their path in the level. */
const below = (path: string, words: Words): Words =>
  Object.fromEntries(Object.entries(words).map(([key, about]) => [key === '' ? path : `${path}/${key}`, about]));

/** What the values in a level file mean, by their path; every entry of a list is `*`. */
const WORDS: Words = {
  '': 'A level of Gravity Quest. Keys that begin with x- are yours: they are kept and not checked.',
  $schema: 'Where the JSON Schema of this format is, for editors.',
  version: 'Version of this format.',
  ...below('conflicts', {
    '': 'What a merge left undecided: `gq check` refuses the level until the list is gone.',
    '*': 'A property that two merged versions changed in different ways.',
    '*/what': 'What it is about, in words.',
    '*/key': 'The property it is about, such as asteroids/k3x9qa/radius.',
    '*/base': 'The value before both changes; left out when there was none.',
    '*/ours': 'The value of our version, which stands in the level; left out when it is deleted there.',
    '*/theirs': 'The value of their version; left out when it is deleted there.',
  }),
  name: 'What players and reports call the level.',
  description: 'What the level teaches or asks for.',
  range: `Farther than this from the centre of every asteroid she is lost, px; ${DEFAULT_RANGE} when left out.`,
  recoil: 'Whether the target of the gun is pulled towards her, too; false when left out.',
  ...below('rules', RULE_WORDS),
  ...below('allow', {
    '': 'Problems that are meant in this level, each with the reason: `gq check` does not report them.',
    ...Object.fromEntries(ALLOWABLE_CODES.map((code) => [code, `Why ${code} is meant in this level.`])),
  }),
  ...Object.assign(
    {},
    ...OBJECT_KINDS.map((kind) => below(KINDS[kind].list === null ? kind : `${KINDS[kind].list}/*`, wordsOfKind(kind))),
  ),
  ...Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, KINDS[kind].aboutList])),
  ...below('runs', {
    '': 'Scripted runs; the first is the one that is shown.',
    '*': 'What a player does: proof that the level can be completed, or that it fails as it should.',
    '*/name': 'Unique in the level.',
    '*/holds': 'When the gun is held.',
    '*/holds/*': '[press, release): ticks of 1/60 s; the gun is held from press up to, not including, release.',
    '*/notes': 'Notes at ticks; `gq fmt` sorts them by tick.',
    '*/notes/*': 'What somebody wrote at a tick of a run. It changes nothing in play.',
    '*/notes/*/tick': 'The tick that it is about.',
    '*/notes/*/text': 'What it says, on one line, without white space at its ends.',
  }),
};

/** The zod schema of a value, by the type of its shape. */
type BareSchemaOf<S> = S extends { readonly only: infer V extends z.core.util.Literal }
  ? z.ZodLiteral<V>
  : S extends { readonly type: 'number' }
    ? z.ZodNumber
    : S extends { readonly type: 'integer' }
      ? z.ZodInt
      : S extends { readonly type: 'boolean' }
        ? z.ZodBoolean
        : S extends { readonly type: 'string' }
          ? z.ZodString
          : S extends { readonly least: 2; readonly each: infer E }
            ? z.ZodTuple<[SchemaOf<E>, SchemaOf<E>], null>
            : S extends { readonly each: infer E }
              ? z.ZodArray<SchemaOf<E>>
              : S extends { readonly keys: infer K }
                ? z.ZodObject<{ -readonly [key in keyof K]: SchemaOf<K[key]> }, z.core.$strict>
                : z.ZodUnknown;
type Type<S> = S extends z.core.$ZodType ? S : never;
type SchemaOf<S> = Type<S extends { readonly optional: true } ? z.ZodOptional<Type<BareSchemaOf<S>>> : BareSchemaOf<S>>;

type ObjectSchemas = { [K in SingleKind]: ObjectSchema<K> } & {
  [K in ListedKind as ListOf<K>]: z.ZodOptional<z.ZodArray<ObjectSchema<K>>>;
};
type Keys = typeof LEVEL_SHAPE.keys;
type LevelKeys = {
  -readonly [key in keyof Keys]: key extends keyof ObjectSchemas ? ObjectSchemas[key] : SchemaOf<Keys[key]>;
};

function bareSchema(
  { type, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY, only, pattern, each, keys }: LevelShape,
  path: string,
): z.ZodType {
  const inner = (shape: LevelShape, step: string) => schemaOf(shape, path === '' ? step : `${path}/${step}`);
  if (only !== undefined) return z.literal(only as number);
  switch (type) {
    case undefined:
      return z.unknown();
    case 'boolean':
      return z.boolean();
    case 'number':
      return z.number().min(least).max(most);
    case 'integer':
      return z.int().min(least).max(most);
    case 'string': {
      let text = z.string();
      if (least > 0) text = text.min(least);
      if (most < Number.POSITIVE_INFINITY) text = text.max(most);
      return pattern === undefined ? text : text.regex(new RegExp(pattern));
    }
    case 'array': {
      const entry = inner(each ?? {}, '*');
      return least === most ? z.tuple([entry, entry]) : z.array(entry).max(most);
    }
    case 'object':
      return z.strictObject(Object.fromEntries(Object.entries(keys ?? {}).map(([key, its]) => [key, inner(its, key)])));
  }
}

/** The zod schema of a shape. @param path leads to the value, in the table of words */
function schemaOf(shape: LevelShape, path: string): z.ZodType {
  const about = WORDS[path];
  const described = (schema: z.ZodType) => (about === undefined ? schema : schema.describe(about));
  const bare = bareSchema(shape, path);
  // an object is described itself, as it is used elsewhere, too; of other values the whole is
  if (shape.keys !== undefined) return shape.optional === true ? described(bare).optional() : described(bare);
  return described(shape.optional === true ? bare.optional() : bare);
}

/** The zod schema of a level file. Lists that are left out are empty. */
export const levelSchema = schemaOf(LEVEL_SHAPE, '') as z.ZodObject<LevelKeys, z.core.$strict>;

/** The zod schema of each kind of object in a file. */
export const OBJECT_SCHEMAS = Object.fromEntries(
  OBJECT_KINDS.map((kind) => {
    const { list } = KINDS[kind];
    const schema = levelSchema.shape[(list ?? kind) as 'asteroids'];
    return [kind, list === null ? schema : schema.unwrap().element];
  }),
) as unknown as { readonly [K in ObjectKind]: ObjectSchema<K> };

/** The zod schema of `rules` in a level file or in the configuration of a folder. */
export const rulesSchema = levelSchema.shape.rules.unwrap();
