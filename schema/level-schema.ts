import * as z from 'zod';
import {
  type FieldsOf,
  KINDS,
  type ListedKind,
  type ListOf,
  OBJECT_KINDS,
  type ObjectKind,
  type SingleKind,
} from './basics/index.ts';
import { LEVEL_SHAPE, LEVEL_WORDS, type Shape as LevelShape, type Words } from './level/index.ts';

type Plain<F> = F extends { readonly type: 'number' } ? z.ZodNumber : z.ZodBoolean;
type FieldSchema<F> = F extends { readonly default: unknown } ? z.ZodOptional<Plain<F>> : Plain<F>;
type Id = { id: z.ZodOptional<z.ZodString> };
type Shape<K extends ObjectKind> = (K extends ListedKind ? Id : unknown) & {
  -readonly [F in keyof FieldsOf<K>]: FieldSchema<FieldsOf<K>[F]>;
};
type ObjectSchema<K extends ObjectKind> = z.ZodObject<{ [F in keyof Shape<K>]: Shape<K>[F] & z.core.$ZodType }, z.core.$strict>;

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
  { type, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY, only, among, pattern, each, keys }: LevelShape,
  path: string,
  words: Words,
): z.ZodType {
  const inner = (shape: LevelShape, step: string) => schemaOf(shape, path === '' ? step : `${path}/${step}`, words);
  if (only !== undefined) return z.literal(only as number);
  if (among !== undefined) return z.enum(among);
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
export function schemaOf(shape: LevelShape, path: string, words: Words): z.ZodType {
  const about = words[path];
  const described = (schema: z.ZodType) => (about === undefined ? schema : schema.describe(about));
  const plain = bareSchema(shape, path, words);
  const bare = shape.nullable === true ? plain.nullable() : plain;
  // an object is described itself, as it is used elsewhere, too; of other values the whole is
  if (shape.keys !== undefined) return shape.optional === true ? described(bare).optional() : described(bare);
  return described(shape.optional === true ? bare.optional() : bare);
}

/** The zod schema of a level file. Lists that are left out are empty. */
export const levelSchema = schemaOf(LEVEL_SHAPE, '', LEVEL_WORDS) as z.ZodObject<LevelKeys, z.core.$strict>;

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
