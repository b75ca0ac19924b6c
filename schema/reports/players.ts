import * as z from 'zod';
import { fitReportSchema } from './forecast.ts';
import { playVerdict } from './parts.ts';

const share = z.number().min(0).max(1);
const index = z.int().min(0).describe("Within the level's own list of that kind, from 0.");
const count = z.int().min(0);
const px = z.number().describe('px of the level.');
const ofAttempts = {
  attempts: count,
  successes: count,
  share: share.describe('Of the attempts that succeed.'),
  low: share.describe('Lower end of the 95 % interval (Wilson).'),
  high: share.describe('Upper end of it.'),
};
const interval = { share, low: share, high: share };
const play = z.string().describe('The file of the play, or file and line.');
const verdict = playVerdict.exclude(['ok']);
const refused = z
  .array(z.strictObject({ play, verdict, message: z.string() }))
  .describe('Plays that do not count, as gq verify calls them.');
const cause = z.strictObject({
  kind: z
    .enum(['nova', 'asteroid', 'alien', 'lost', 'timeout', 'left', 'minerals'])
    .describe('left: the player gave up; minerals: she reached the black hole with too few.'),
  index: index.nullable(),
});
const quartiles = z
  .strictObject({ count, low: z.number(), median: z.number(), high: z.number() })
  .nullable()
  .describe('Ticks after the reference run, negative for earlier: the quartiles; null without any.');

/** The zod schema of what players teach about a level, in reports. */
export const playersReportSchema = z
  .strictObject({
    ...ofAttempts,
    players: count.describe('Players that are known.'),
    playersWhoSucceed: count,
    minerals: z.array(count).describe('Attempts that reach the black hole with 0, 1, ... minerals.'),
    refused,
    causes: z.array(z.strictObject({ cause, count, share })).describe('Why attempts fail; shares of all failures.'),
    clusters: z
      .array(z.strictObject({ cause, count, share, x: px, y: px, spread: px.describe('Root of the mean squared distance.') }))
      .describe('Places where many attempts fail for one cause.'),
    failures: z.array(z.strictObject({ play, cause, x: px, y: px, tick: count, time: z.number() })),
    failureTimes: z.array(count).describe('Failures in each second from the start.'),
    byAttempt: z
      .array(
        z.strictObject({
          number: z.int().min(1),
          ...ofAttempts,
          first: count.describe('Players who succeed for the first time.'),
        }),
      )
      .describe('Success by attempt number of players that are known.'),
    routes: z
      .array(
        z.strictObject({
          asteroids: z.array(index),
          count,
          share,
          quickest: z.number().describe('s'),
          play,
          run: z.string().nullable().describe("The level's own run that takes this way; null: players found it."),
        }),
      )
      .describe('The ways by which attempts succeed.'),
    reference: z
      .strictObject({ name: z.string().nullable(), holds: z.array(z.tuple([z.int(), z.int()])) })
      .nullable()
      .describe('The run that presses and releases are compared with.'),
    edges: z
      .array(
        z.strictObject({
          type: z.enum(['start', 'press', 'release']),
          hold: index,
          tick: count,
          reached: count.describe('Attempts that came so far.'),
          failed: count.describe('Attempts that failed before the next press or release.'),
          ...interval,
          succeeding: quartiles,
          failing: quartiles,
          expected: z.strictObject(interval).nullable().describe('What the model expects at `noise`.'),
          players: z.enum(['more', 'less']).nullable().describe('Whether players fail more or less often than expected.'),
        }),
      )
      .describe('Between which presses and releases of the reference run attempts fail.'),
    noise: z
      .strictObject({ ms: z.number(), low: z.number(), high: z.number(), capped: z.boolean() })
      .nullable()
      .describe('Timing noise that explains the share of attempts that succeed; capped: at least that.'),
    fit: fitReportSchema,
  })
  .describe('What players teach, with --plays.');

/** The zod schema of what was read with --plays, in reports. */
export const playsReportSchema = z
  .strictObject({
    found: count.describe('Plays that were found.'),
    refused,
    elsewhere: z.array(z.strictObject({ level: z.string(), count })).describe('Plays of other levels, by the hash of the level.'),
    ignoredFiles: count.describe('Files in the directories that are no plays.'),
  })
  .describe('What was read, with --plays.');
