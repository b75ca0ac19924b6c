import * as z from 'zod';

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
export const playVerdict = z.enum(['ok', 'claim-differs', 'stale-level', 'other-accuracy', 'unknown-engine', 'malformed', 'too-long']);
