import * as z from 'zod';
import { rulesSchema } from '../level-schema.ts';

/** The first key of every report. */
export const version = z.literal(1).describe('Of the shape of this report. New keys may be added to it without a new version.');

/** A problem in reports. */
export const problem = z.strictObject({
  code: z.string(),
  severity: z.enum(['error', 'warning']),
  message: z.string(),
  line: z.int().min(1).nullable(),
  column: z.int().min(1).nullable(),
  pointer: z.string().describe("JSON pointer; '' is the whole file."),
});

/** What a play is found to be, in reports; `verifyPlay` of the game has the same. */
export const playVerdict = z.enum([
  'ok',
  'claim-differs',
  'stale-level',
  'other-accuracy',
  'unknown-engine',
  'malformed',
  'too-long',
]);

/** The zod schema of the terms under which a report says something about a level. */
export const termsReportSchema = z
  .strictObject({
    accuracy: z.string().describe('How exactly it is simulated: the name of an accuracy, or of a custom setting.'),
    maxTime: z.number().min(0).describe('Simulated time after which a run is a timeout, s.'),
    maxWork: z.int().min(1).describe('The most work that the level may cost, pieces of motion.'),
    rules: rulesSchema.describe(
      "The rules that have another value than in the original game: the level's own, and those of its folder.",
    ),
  })
  .describe('Under which terms all this holds.');

/** Under which terms a report says something about a level. */
export type TermsReport = z.infer<typeof termsReportSchema>;
