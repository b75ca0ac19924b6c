import * as z from 'zod';
import { RULE_NAMES } from '../basics/default-rules.ts';
import { termsReportSchema, version } from './parts.ts';

const rule = z.enum(RULE_NAMES as [string, ...string[]]);
const isRelative = z.boolean().describe("Whether it is a share of each level's own value.");

/** The zod schema of what `gq tune` prints as JSON. */
export const tuneReportSchema = z.strictObject({
  version,
  accuracy: z.string(),
  changes: z.array(z.strictObject({ rule, amount: z.number(), isRelative })).describe('Made together.'),
  sweep: z
    .strictObject({ rule, isRelative, amounts: z.array(z.number()) })
    .nullable()
    .describe('On top of the changes.'),
  levels: z
    .array(
      z.strictObject({
        file: z.string(),
        name: z.string(),
        terms: termsReportSchema.describe('Under which terms all this holds, without the changes.'),
        run: z.string().nullable().describe('The run that is looked at: the first that completes the level.'),
        room: z
          .number()
          .nullable()
          .describe('The least share of its own value by which a rule may change before the run fails; null: it never did.'),
        values: z
          .array(
            z.strictObject({
              value: z.number().nullable().describe('Of the swept rule; null without a sweep.'),
              state: z.enum(['kept', 'other', 'unproven', 'impossible']),
              holds: z
                .array(z.tuple([z.int(), z.int()]))
                .nullable()
                .describe('The other run: [press, release) in ticks of 1/60 s.'),
            }),
          )
          .describe('One for each amount of the sweep, or the one of the changes.'),
        intervals: z.array(
          z.strictObject({
            rule,
            own: z.number(),
            low: z.number().nullable(),
            high: z.number().nullable(),
            isLowBound: z.boolean().describe('Whether the run fails below `low`; false: nothing was tried there.'),
            isHighBound: z.boolean(),
            matters: z.boolean().describe('Whether the run is another, in any bit, at an end of what was tried.'),
          }),
        ),
        why: z.string().nullable().describe('Why there is nothing to tell.'),
      }),
    )
    .describe('Those first whose run fails first.'),
  independent: z.array(rule).describe('Rules that were tried and that no level depends on.'),
});

/** What `gq tune` prints as JSON. */
export type TuneReport = z.infer<typeof tuneReportSchema>;
