import * as z from 'zod';
import { playVerdict, version } from './parts.ts';

const tick = z.int().min(0);
const claim = z.strictObject({
  tick: tick.describe('Ticks of 1/60 s that were played.'),
  minerals: z.int().min(0),
  outcome: z.enum(['completed', 'collided', 'lost', 'timeout', 'left']),
});

/** The zod schema of what `gq verify` prints as JSON: a line for each play. */
export const verifyReportSchema = z
  .strictObject({
    version,
    file: z.string().nullable().describe('The file or pack; null for a play from standard input.'),
    line: z.int().min(1).nullable().describe('The line of standard input or of a pack; null for a file.'),
    id: z.union([z.string(), z.number()]).nullable().describe('What the line of standard input calls the play.'),
    verdict: playVerdict,
    message: z.string().describe('The verdict in words.'),
    level: z
      .strictObject({
        hash: z.string(),
        file: z.string().nullable().describe('The level file with this hash; null if there is none.'),
        name: z.string().nullable(),
        mayBe: z.string().nullable().describe('Of a stale level: the level file that it may have become.'),
      })
      .nullable()
      .describe('null if the bytes are no play; so are the next three.'),
    engine: z.string().nullable(),
    accuracy: z.string().nullable(),
    claim: claim.nullable().describe('What the play claims.'),
    found: claim.nullable().describe('What its inputs lead to; null unless they were replayed to the end.'),
    time: z.number().nullable().describe('When the replay ended, s to the last bit; null unless it did.'),
    differs: z
      .strictObject({ from: tick, to: tick })
      .nullable()
      .describe('The ticks between which the replay first differs from the play.'),
    challenge: z
      .enum(['none', 'unchecked', 'ok', 'missing', 'forged', 'expired'])
      .nullable()
      .describe('unchecked: the play has one, and no key was given.'),
    signs: z
      .strictObject({
        fastEdges: z.int().min(0).describe('Presses and releases less than 2 ticks after the one before.'),
        publishedRun: z.string().nullable().describe("The level's own run that the play repeats."),
      })
      .nullable()
      .describe('What may mean that the play is no person’s; null unless the verdict is ok. It rejects nothing.'),
  })
  .describe('One play. Each line of the output is such an object, in the order of the plays.');

/** What `gq verify` prints as JSON for a play. */
export type VerifyReport = z.infer<typeof verifyReportSchema>;
