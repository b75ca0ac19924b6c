import * as z from 'zod';
import { VERDICTS } from './check.ts';
import { termsReportSchema, version } from './parts.ts';

const index = z.int().min(0);
const ticks = z.int().min(0);

const proposal = z.strictObject({
  kind: z
    .enum(['move', 'resize', 'drop', 'range', 'velocity', 'run'])
    .describe('What is changed; `run`: only a run, the level stays as it is.'),
  object: z
    .strictObject({
      kind: z.string().describe('A kind of object, as in a level file.'),
      index: index.describe("Within the level's own list of that kind, from 0."),
      id: z.string().nullable(),
    })
    .nullable()
    .describe('What is changed; null for the range and for a run.'),
  size: z
    .number()
    .min(0)
    .describe(
      'px: the way of an object that is moved; the difference of a radius or of the range; of a velocity the way in a second; the diameter of an object that is removed; 0 for a run.',
    ),
  words: z.string().describe('The change as a sentence.'),
  edits: z
    .array(
      z.strictObject({
        pointer: z.string().describe('JSON pointer into the level file.'),
        from: z.number().nullable().describe('The number of the level; null for an object.'),
        to: z.number().nullable().describe('The new number; null: the object is removed.'),
      }),
    )
    .describe('Edits of the level file, besides that of a run.'),
  run: z.strictObject({
    origin: z
      .enum(['own', 'adjusted', 'search'])
      .describe('own: a run of the level as it is; adjusted: one with other holds; search: a new run.'),
    name: z.string().nullable().describe("The level's run; null for a new one."),
    shifted: ticks
      .nullable()
      .describe('Ticks by which presses and releases of an adjusted run are shifted, in all; otherwise null.'),
    holds: z.array(z.tuple([z.int(), z.int()])).describe('[press, release) in ticks of 1/60 s.'),
    tick: ticks,
    time: z.number().min(0).describe('Seconds from the start.'),
    minerals: z.array(index).describe('Those that it collects.'),
    hash: z.string().describe('As gq simulate gives it for the changed level.'),
  }),
});

/** The zod schema of what `gq fix` prints as JSON. */
export const fixReportSchema = z.strictObject({
  version,
  level: z.string(),
  accuracy: z.string(),
  terms: termsReportSchema,
  verdict: z.enum(VERDICTS).describe('On the level as it is. With `completable` there is nothing to fix.'),
  completedBy: z.string().nullable().describe('A run that completes the level as it is; null if none of its own does.'),
  impossible: z.strictObject({ code: z.string(), reason: z.string() }).nullable().describe('The proof, if there is one.'),
  proposals: z.array(proposal).describe('Each of another kind, the smallest first.'),
  effort: z.strictObject({ runs: index, ticks, seconds: z.number().min(0).describe('Wall time.'), seed: index }),
  isFinished: z.boolean().describe('Whether all was tried; false: --budget or --effort ended it.'),
  written: z.int().min(1).nullable().describe('The number of the proposal that was written to the file, from 1.'),
});

/** What `gq fix` prints as JSON. */
export type FixReport = z.infer<typeof fixReportSchema>;
