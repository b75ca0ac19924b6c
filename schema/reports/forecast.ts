import * as z from 'zod';

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
