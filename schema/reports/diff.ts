import * as z from 'zod';
import { VERDICTS } from '../basics/index.ts';
import { checkReportSchema, runReportSchema } from './check.ts';
import { termsReportSchema } from './parts.ts';

const index = z.int().min(0).describe('From 0.');
const fieldChange = z
  .strictObject({ key: z.string(), before: z.json().optional(), after: z.json().optional() })
  .describe('A value that is missing here was missing in the file.');
const fields = z.array(fieldChange);
const keyOrder = z
  .strictObject({ before: z.array(z.string()), after: z.array(z.string()) })
  .nullable()
  .describe('The order of the x- keys, where it does not follow from the fields.');
const of = z.string().describe('The key of the list, or of the object that a level has once.');

const change = z.discriminatedUnion('type', [
  z.strictObject({ type: z.literal('value'), ...fieldChange.shape }).describe('A key of the level.'),
  z
    .strictObject({
      type: z.literal('map'),
      of: z.string().describe('`rules` or `allow`.'),
      fields,
      keys: keyOrder,
      empty: z
        .strictObject({ before: z.boolean(), after: z.boolean() })
        .describe('Whether the key was, and is, written with nothing in it.'),
    })
    .describe('Rules of the level, or codes that it allows.'),
  z.strictObject({ type: z.enum(['added', 'removed']), of, index, entry: z.record(z.string(), z.json()) }),
  z.strictObject({
    type: z.literal('changed'),
    of,
    before: index,
    after: index,
    matchedBy: z.enum(['id', 'content', 'place']).describe('How the object was found again; all but id are a guess.'),
    fields,
    keys: keyOrder,
  }),
  z
    .strictObject({ type: z.literal('order'), of, pairs: z.array(z.tuple([index, index])) })
    .describe('Common entries in another order: [before, after], sorted by the second.'),
  z
    .strictObject({ type: z.literal('empty-list'), of, before: z.boolean(), after: z.boolean() })
    .describe('Whether the list was, and is, written with nothing in it.'),
  z.strictObject({ type: z.literal('keys'), before: z.array(z.string()), after: z.array(z.string()) }),
]);

const { outcome, holds, tick, time } = runReportSchema.shape;

const version = z.strictObject({
  file: z.string(),
  name: z.string(),
  terms: termsReportSchema,
  verdict: z.enum(VERDICTS),
  problems: checkReportSchema.shape.levels.element.shape.problems.describe('Why it is not a valid level.'),
  mineralCount: z.int().min(0).nullable(),
  run: z
    .strictObject({
      name: z.string(),
      holds,
      outcome,
      with: runReportSchema.shape.with,
      time,
      tick,
      minerals: z.int().min(0).describe('How many different ones it collects.'),
      clearance: z.number().nullable().describe('px'),
      slack: z
        .array(z.tuple([z.int().min(0), z.int().min(0)]))
        .nullable()
        .describe(
          '[ticks earlier, ticks later] that each press and release can move alone; null for a run that fails, or if not measured.',
        ),
      smallestWindow: z.int().min(0).nullable().describe('Ticks that the tightest press or release can move in all.'),
    })
    .nullable()
    .describe('The first run that completes the level, else its first.'),
});

/** The zod schema of what `gq diff` prints as JSON. */
export const diffReportSchema = z.strictObject({
  version: z.literal(1),
  before: z.string().describe('What was compared: a revision or a path.'),
  after: z.string(),
  rules: z
    .array(z.strictObject({ rule: z.string(), before: z.number().nullable(), after: z.number().nullable() }))
    .describe('Rules that gq.config.json sets differently on the two sides; null: not set.'),
  levels: z.array(
    z.strictObject({
      file: z.string(),
      status: z
        .enum(['added', 'removed', 'changed', 'renamed', 'layout', 'rules'])
        .describe(
          'layout: the content is the same; rules: the file is the same, and plays differently by the rules of its folder.',
        ),
      words: z.array(z.string()).describe('What changed, for people.'),
      effects: z.array(z.string()).describe('What follows from it, for people.'),
      before: version.nullable(),
      after: version.nullable(),
      changes: z.array(change).nullable().describe('Turns the first version into the second; null unless both are valid levels.'),
    }),
  ),
  same: z
    .int()
    .min(0)
    .describe('Levels whose file is the same, and which play as before although the rules of the folder changed.'),
});

/** What `gq diff` prints as JSON. */
export type DiffReport = z.infer<typeof diffReportSchema>;
