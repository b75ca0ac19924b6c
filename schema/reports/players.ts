import * as z from 'zod';
import { playVerdict } from './parts.ts';

const share = z.number().min(0).max(1);
const count = z.int().min(0);
const ms = z.number().min(0);
const ofPlayers = z.strictObject({ p: share, low: share, high: share });

/** The zod schema of what the model of players expects of a level, in reports. */
export const forecastReportSchema = z
  .strictObject({
    parameters: z
      .strictObject({
        motorMs: ms.describe('Noise of the finger, ms.'),
        weber: z.number().min(0).describe('Noise of the sense of time, as a share of the interval.'),
        reactionMs: ms.describe('Reaction time, ms.'),
        lookaheadMs: ms.describe('How far ahead a player foresees her motion, ms.'),
        planMs: ms.describe('Error of a first guess at what cannot be foreseen, ms.'),
        learning: z.number().min(0).describe('Exponent of the power law of practice.'),
        scale: z.number().min(0).describe('Factor on noise and errors of the median player.'),
        spread: z.number().min(0).describe("Standard deviation of the logarithm of players' factors."),
      })
      .describe('The model.'),
    firstErrorMs: ms.describe('How much the median player misses presses and releases by at first, ms.'),
    lastErrorMs: ms.describe('The same after as much practice as the last attempt has.'),
    players: count.describe('How many synthetic players were simulated.'),
    attempts: z
      .array(
        z.strictObject({
          number: z.int().min(1),
          pass: ofPlayers.describe('Those who succeed at this attempt, if all still play, with the 90 % interval.'),
          range: z
            .tuple([share, share])
            .describe("A player's own pass rate at this attempt is between these with 90 % probability."),
          solved: ofPlayers.describe('Those who have succeeded by then, with the 90 % interval.'),
        }),
      )
      .describe('Their attempts.'),
    half: z.int().min(1).nullable().describe('Attempts within which half of them succeed; null: more than were simulated.'),
    most: z
      .int()
      .min(1)
      .nullable()
      .describe('Attempts within which nine in ten of them succeed; null: more than were simulated.'),
  })
  .describe('What a model of players expects. It says nothing about people unless it was fitted to their plays.');

/** What the model of players expects of a level, in reports. */
export type ForecastReport = z.infer<typeof forecastReportSchema>;

const fitted = z.strictObject({ value: z.number(), low: z.number(), high: z.number() });

/** The zod schema of the player model fitted to plays, in reports. */
export const fitReportSchema = z
  .strictObject({
    players: count.describe('Players whose plays were used.'),
    attempts: count,
    edges: count.describe('Presses and releases that were compared with the reference run.'),
    scale: fitted.describe("The median player's noise as a multiple of the uncalibrated model's, with the 90 % interval."),
    learning: fitted.describe('Exponent of the power law of practice, with the 90 % interval.'),
    spread: fitted.nullable().describe("Standard deviation of the logarithm of players' factors; null with a single player."),
    forecast: forecastReportSchema,
  })
  .nullable()
  .describe('The player model fitted to the plays of known players by maximum likelihood; null: nothing can be fitted.');

/** The player model fitted to plays, in reports. */
export type FitReport = NonNullable<z.infer<typeof fitReportSchema>>;

const index = z.int().min(0).describe("Within the level's own list of that kind, from 0.");
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
