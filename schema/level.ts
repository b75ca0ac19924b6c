import * as z from 'zod';
import { ALLOWABLE_CODES, type AllowableCode } from './adjustable.ts';
import type { Field } from './kind.ts';
import {
  type FieldsOf,
  fieldsOf,
  KINDS,
  LISTED_KINDS,
  type ListedKind,
  type ListOf,
  OBJECT_KINDS,
  type ObjectKind,
  SINGLE_KINDS,
  type SingleKind,
} from './kinds.ts';
import { DEFAULT_RANGE, LEVEL_VERSION } from './level-constants.ts';
import { LIMITS } from './limits.ts';
import { NOTE_TEXT } from './notes.ts';
import { rulesSchema } from './rules-schema.ts';

export * from './level-types.ts';
export { DEFAULT_RANGE, LEVEL_VERSION };

type Plain<F> = F extends { readonly type: 'number' } ? z.ZodNumber : z.ZodBoolean;
type FieldSchema<F> = F extends { readonly default: unknown } ? z.ZodOptional<Plain<F>> : Plain<F>;
type Id = { id: z.ZodOptional<z.ZodString> };
type Shape<K extends ObjectKind> = (K extends ListedKind ? Id : unknown) & {
  -readonly [F in keyof FieldsOf<K>]: FieldSchema<FieldsOf<K>[F]>;
};
type ObjectSchema<K extends ObjectKind> = z.ZodObject<{ [F in keyof Shape<K>]: Shape<K>[F] & z.core.$ZodType }, z.core.$strict>;

const id = z
  .string()
  .regex(/^[a-z0-9]{2,16}$/)
  .optional()
  .describe(
    'Short random name of this object: it stays while the object is moved and edited. Unique in the level; `gq fmt` adds missing ones.',
  );

function fieldSchema(field: Field): z.core.$ZodType {
  const plain = field.type === 'number' ? z.number().min(field.least).max(field.most) : z.boolean();
  return (field.default === undefined ? plain : plain.optional()).describe(field.about);
}

function objectSchema<K extends ObjectKind>(kind: K): ObjectSchema<K> {
  const { list, about } = KINDS[kind];
  const fields = fieldsOf(kind).map(([name, field]) => [name, fieldSchema(field)]);
  return z.strictObject({ ...(list === null ? {} : { id }), ...Object.fromEntries(fields) }).describe(about) as never;
}

/** The zod schema of each kind of object in a file. */
export const OBJECT_SCHEMAS = Object.fromEntries(OBJECT_KINDS.map((kind) => [kind, objectSchema(kind)])) as {
  readonly [K in ObjectKind]: ObjectSchema<K>;
};

const singles = Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, OBJECT_SCHEMAS[kind]])) as {
  [K in SingleKind]: ObjectSchema<K>;
};

const listSchema = (kind: ListedKind) =>
  z.array(OBJECT_SCHEMAS[kind]).max(LIMITS.objects).optional().describe(KINDS[kind].aboutList);

const lists = Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, listSchema(kind)])) as {
  [K in ListedKind as ListOf<K>]: z.ZodOptional<z.ZodArray<ObjectSchema<K>>>;
};

const tick = z.int().min(0).max(LIMITS.tick);

/** A hold, as a pair of ticks. */
const hold = z
  .tuple([tick, tick])
  .describe('[press, release): ticks of 1/60 s; the gun is held from press up to, not including, release.');

const note = z
  .strictObject({
    tick: tick.describe('The tick that it is about.'),
    text: z
      .string()
      .min(1)
      .max(LIMITS.note)
      .regex(NOTE_TEXT)
      .describe('What it says, on one line, without white space at its ends.'),
  })
  .describe('What somebody wrote at a tick of a run. It changes nothing in play.');

const run = z
  .strictObject({
    name: z.string().min(1).max(80).describe('Unique in the level.'),
    holds: z.array(hold).max(LIMITS.holds).describe('When the gun is held.'),
    notes: z.array(note).max(LIMITS.notes).optional().describe('Notes at ticks; `gq fmt` sorts them by tick.'),
  })
  .describe('What a player does: proof that the level can be completed, or that it fails as it should.');

const conflict = z
  .strictObject({
    what: z.string().describe('What it is about, in words.'),
    key: z.string().min(1).describe('The property it is about, such as asteroids/k3x9qa/radius.'),
    base: z.unknown().optional().describe('The value before both changes; left out when there was none.'),
    ours: z
      .unknown()
      .optional()
      .describe('The value of our version, which stands in the level; left out when it is deleted there.'),
    theirs: z.unknown().optional().describe('The value of their version; left out when it is deleted there.'),
  })
  .describe('A property that two merged versions changed in different ways.');

const allow = z
  .strictObject(
    Object.fromEntries(
      ALLOWABLE_CODES.map((code) => [
        code,
        z.string().min(1).regex(/\S/).max(LIMITS.reason).optional().describe(`Why ${code} is meant in this level.`),
      ]),
    ) as { [code in AllowableCode]: z.ZodOptional<z.ZodString> },
  )
  .describe('Problems that are meant in this level, each with the reason: `gq check` does not report them.');

/** The zod schema of a level file. Lists that are left out are empty. */
export const levelSchema = z
  .strictObject({
    $schema: z.string().optional().describe('Where the JSON Schema of this format is, for editors.'),
    version: z.literal(LEVEL_VERSION).describe('Version of this format.'),
    conflicts: z
      .array(conflict)
      .max(LIMITS.conflicts)
      .optional()
      .describe('What a merge left undecided: `gq check` refuses the level until the list is gone.'),
    name: z.string().min(1).max(120).describe('What players and reports call the level.'),
    description: z.string().max(2000).optional().describe('What the level teaches or asks for.'),
    ...singles,
    range: z
      .number()
      .min(LIMITS.leastRadius)
      .max(LIMITS.radius)
      .optional()
      .describe(`Farther than this from the centre of every asteroid she is lost, px; ${DEFAULT_RANGE} when left out.`),
    recoil: z.boolean().optional().describe('Whether the target of the gun is pulled towards her, too; false when left out.'),
    rules: rulesSchema.optional(),
    allow: allow.optional(),
    ...lists,
    runs: z.array(run).max(LIMITS.runs).optional().describe('Scripted runs; the first is the one that is shown.'),
  })
  .describe('A level of Gravity Quest. Keys that begin with x- are yours: they are kept and not checked.');

/** The content of a level file: what may be left out may be missing. */
export type LevelFile = z.infer<typeof levelSchema>;

/** An entry of `conflicts` in a level file: a property that two merged versions changed in different ways. */
export type FileConflict = NonNullable<LevelFile['conflicts']>[number];
