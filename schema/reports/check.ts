import * as z from 'zod';
import { VERDICTS } from '../basics/index.ts';
import { problem, termsReportSchema, version } from './parts.ts';
import { forecastReportSchema, playersReportSchema, playsReportSchema } from './players.ts';

const time = z.number().min(0).describe('Seconds from the start.');
const index = z.int().min(0).describe("Within the level's own list of that kind, from 0.");
const kind = z.enum(['nova', 'asteroid', 'alien', 'blackHole']);

/** The zod schema of a run in reports. */
export const runReportSchema = z.strictObject({
  level: z.string(),
  accuracy: z.string(),
  terms: termsReportSchema,
  holds: z.array(z.tuple([z.int(), z.int()])).describe('[press, release) in ticks of 1/60 s.'),
  outcome: z.enum(['completed', 'collided', 'lost', 'timeout']),
  with: z.strictObject({ kind, index }).nullable(),
  time,
  tick: z.int().min(0).describe('The tick of 1/60 s in which the run ended.'),
  minerals: z.array(z.strictObject({ index, time })),
  events: z.array(z.looseObject({ time, type: z.string() })),
  clearance: z
    .strictObject({ distance: z.number().describe('px'), kind, index, time })
    .nullable()
    .describe('The closest that she came to a hazard.'),
  final: z.strictObject({ x: z.number(), y: z.number(), vx: z.number(), vy: z.number(), angle: z.number() }),
  samples: z
    .array(z.tuple([z.number(), z.number(), z.number(), z.number(), z.number(), z.number()]))
    .describe('[t, x, y, vx, vy, angle]'),
  hash: z.string().describe('Covers every sample, event and the final state bit for bit.'),
});

/** The zod schema of what `gq simulate` prints as JSON. */
export const simulateReportSchema = z.strictObject({ version, ...runReportSchema.shape });

/** What `gq simulate` prints as JSON. */
export type SimulateReport = z.infer<typeof simulateReportSchema>;

/** A run in reports. */
export type RunReport = z.infer<typeof runReportSchema>;

const count = z.int().min(0);
const lostPlace = z.strictObject({
  x: z.number().describe('px'),
  y: z.number().describe('px'),
  tick: count.describe('Since when it is lost there.'),
  open: count
    .nullable()
    .describe('The last tick on the way there at which the black hole could still be reached; null if none is known.'),
  alive: count.describe('The longest that she was seen alive after it, ticks.'),
  states: count.describe('How many of the states that were examined lie beyond.'),
  run: z.string().nullable().describe("The level's own run that leads there; null: a search came there."),
  holds: z.array(z.tuple([z.int(), z.int()])).describe('They lead there: [press, release) in ticks of 1/60 s.'),
  known: z.enum(['proved', 'not found']).describe('not found: a search found no run from there, which proves nothing.'),
  proof: z.strictObject({ code: z.string(), reason: z.string() }).nullable().describe('Of what is proved; else null.'),
  searched: count.nullable().describe('Ticks of the search that found nothing; null for what is proved.'),
});

/** The zod schema of where a level is already lost although she lives on, in reports. */
export const softlockReportSchema = z.strictObject({
  states: z
    .strictObject({ examined: count, open: count, proved: count, notFound: count, unknown: count })
    .describe(
      'States along runs and of a search: from open ones the black hole can be reached; unknown: the effort did not suffice.',
    ),
  lasting: z
    .strictObject({ proved: count, notFound: count })
    .describe('Lost states after which she was seen alive for a second and more.'),
  places: z.array(lostPlace).describe('Where such states begin, the longest life first.'),
  effort: z.strictObject({ runs: count, ticks: count }),
  isFinished: z.boolean().describe('Whether all was examined; false: the effort ended it.'),
});

/** Where a level is already lost although she lives on, in reports. */
export type SoftlockReport = z.infer<typeof softlockReportSchema>;

const levelReport = z.strictObject({
  file: z.string(),
  name: z.string(),
  terms: termsReportSchema,
  verdict: z.enum(VERDICTS),
  run: runReportSchema.nullable(),
  problems: z.array(problem),
  failure: z
    .strictObject({
      command: z.string().describe('Opens the editor at the failure.'),
      link: z.string().nullable().describe('Opens the editor there; null if no address of a page is known.'),
      tick: z.int().min(0).nullable().describe('At which the run that fails ends; null if no run fails.'),
    })
    .nullable()
    .describe('Where to look at the failure; null if the level does not fail, or the editor can not open its file.'),
  softlocks: softlockReportSchema
    .nullable()
    .optional()
    .describe('Only with --softlocks. null: not examined, as no run completes the level.'),
  ms: z.number().min(0).describe('Wall time.'),
});

/** The zod schema of what `gq check` prints as JSON: one entry per level, and how many levels have each verdict. */
export const checkReportSchema = z.strictObject({
  version,
  levels: z.array(levelReport),
  packs: z
    .array(
      z.strictObject({
        file: z.string(),
        name: z.string().nullable().describe('Its name; null if it is not valid.'),
        problems: z.array(problem),
      }),
    )
    .optional()
    .describe('The pack.json of each folder that was checked; left out if there is none.'),
  summary: z.partialRecord(z.enum(VERDICTS), z.int().min(0)),
  interrupted: z.boolean().describe('Whether a signal ended the check early.'),
  unchecked: z.array(z.string()).describe('The files that were not checked because of that.'),
});

/** A level, as `gq check` reports it. */
export type LevelReport = z.infer<typeof levelReport>;

/** What `gq check` prints as JSON. */
export type CheckReport = z.infer<typeof checkReportSchema>;

const share = z.number().min(0).max(1);
const interval = z.tuple([share, share]).describe('95 % interval (Wilson).');

/** The zod schema of a run's robustness in reports. */
export const robustnessReportSchema = z.strictObject({
  p30: share.describe('Share of attempts that succeed when every press and release is off by Gaussian noise of 30 ms.'),
  p40: share,
  p60: share,
  p80: share,
  certifiedTicks: z
    .int()
    .min(0)
    .describe('All presses and releases may be off by up to this many ticks: every combination was tried, and succeeds.'),
  decided: z.boolean().describe('Whether some shift by one tick more is known to fail; false where there were too many to try.'),
  slack: z
    .array(z.tuple([z.int().min(0), z.int().min(0)]))
    .describe('[ticks earlier, ticks later] that each press and release can move alone: two a hold.'),
  intervals: z.strictObject({ p30: interval, p40: interval, p60: interval, p80: interval }),
  samples: z.int().min(0).describe('Attempts behind each share.'),
});

/** How much imprecision a run tolerates, as reports give it. */
export type RobustnessReport = z.infer<typeof robustnessReportSchema>;

const effort = z.strictObject({
  runs: z.int().min(0).describe('Stretches simulated in one go.'),
  ticks: z.int().min(0).describe('Simulated, of 1/60 s each: the same --effort gives the same answer.'),
  seconds: z.number().min(0).describe('Wall time.'),
  seed: z.int(),
});

const closest = z.strictObject({
  distance: z.number().min(0).describe("px, from her box to the black hole's rim"),
  tick: z.int().min(0),
  holds: runReportSchema.shape.holds,
});

const impossible = z.strictObject({
  code: z.string(),
  reason: z.string(),
  certificate: z.json().describe('What a checker needs to see that the proof holds.'),
});

const solution = z.strictObject({
  level: z.string(),
  accuracy: z.string(),
  terms: termsReportSchema,
  found: z.boolean(),
  holds: runReportSchema.shape.holds.nullable().describe('null: no run was found'),
  outcome: runReportSchema.shape.outcome.nullable(),
  time: time.nullable(),
  tick: z.int().min(0).nullable(),
  minerals: runReportSchema.shape.minerals,
  effort,
  robustness: robustnessReportSchema.nullable(),
  closest: closest
    .nullable()
    .describe('The nearest any run came to the black hole; null when one was found, or nothing was tried.'),
  impossible: impossible.nullable().describe('The proof that no run can do what was asked.'),
  hash: z.string().nullable().describe("The run's, as `simulate` gives it."),
});

/** The zod schema of what `gq solve` prints as JSON: the best run, and with `--count` the others. */
export const solveReportSchema = z.strictObject({
  version,
  ...solution.shape,
  solutions: z.array(solution).optional().describe('With --count above 1: all of them, best first.'),
});

/** The zod schema of what `gq solve` prints as JSON for several levels or a pack. */
export const solveSetReportSchema = z.strictObject({
  version,
  levels: z.array(
    z.strictObject({
      file: z.string(),
      name: z.string(),
      verdict: z.enum(['found', 'impossible', 'not-found', 'invalid', 'crashed']),
      solved: solveReportSchema.nullable().describe('As for a single level; null if nothing was tried.'),
      why: z.string().nullable().describe('Why nothing was tried.'),
      problems: z.array(problem),
      ms: z.number().min(0).describe('Wall time; 0 in a report of gq merge.'),
    }),
  ),
  summary: z.record(z.string(), z.int().min(0)).describe('The number of levels for each verdict.'),
});

/** What `gq solve` prints as JSON for several levels or a pack. */
export type SolveSetReport = z.infer<typeof solveSetReportSchema>;

/** What `gq solve` prints as JSON for one level. */
export type SolveReport = z.infer<typeof solveReportSchema>;

/** One run that `gq solve` found, or what it found out instead. */
export type SolutionReport = z.infer<typeof solution>;

const runFound = z.strictObject({
  holds: runReportSchema.shape.holds,
  time,
  tick: z.int().min(0),
  minerals: z.array(index).describe('Different ones that it collects, sorted.'),
});

/** A run that reaches its goal, in brief. */
export type RunFoundReport = z.infer<typeof runFound>;

const measuredDifficulty = z.strictObject({
  run: z.strictObject({ name: z.string().nullable().describe('null: not of the level, a search found it'), ...runFound.shape }),
  grade: z
    .strictObject({ value: z.number().min(1).max(10), word: z.string() })
    .describe('An estimate: the lowest that any of the compared runs gives.'),
  comparison: z
    .strictObject({
      runs: z.array(
        z.strictObject({
          name: z.string().nullable().describe('null: not of the level, a search found it'),
          ...runFound.shape,
          p40: share.describe('Success under timing noise of 40 ms, measured briefly.'),
          sigmaAtHalf: z
            .number()
            .min(0)
            .describe('Timing noise at which every second attempt succeeds, ms, measured briefly; at most 500.'),
          grade: z.number().min(1).max(10).describe('The grade if it were the only run, measured briefly.'),
        }),
      ),
      meanP40: share,
      meanGrade: z.number().min(1).max(10),
    })
    .describe('The runs that were compared; the first forgives most and is the one measured. And their means.'),
  robustness: robustnessReportSchema,
  sigmaAtHalf: z
    .strictObject({ ms: z.number(), low: z.number(), high: z.number(), capped: z.boolean() })
    .describe('Timing noise at which every second attempt succeeds, with its 95 % interval; capped: at least that.'),
  smallestWindow: z
    .int()
    .min(0)
    .nullable()
    .describe('Ticks that the tightest press or release can move in all; null without any.'),
  presses: z.int().min(0),
  length: time,
  randomPlay: z.strictObject({ share, low: share, high: share, samples: z.int() }).describe('How often random play wins.'),
  mineralsExtra: z
    .strictObject({ run: runFound, time: z.number(), presses: z.int(), p40: z.number() })
    .nullable()
    .describe('What a run with all minerals costs beyond; null where none is known.'),
  shortcuts: z.strictObject({
    withoutPressing: runFound.nullable(),
    onePress: z.strictObject({
      count: z.int(),
      tried: z.int(),
      length: z.int().describe('Presses and releases were tried up to this tick.'),
      stride: z
        .int()
        .min(1)
        .describe('Only multiples of this many ticks were tried: 1, every tick, in the report on a single level.'),
      example: runFound.nullable(),
    }),
    withoutAsteroid: z.array(
      z.strictObject({
        asteroid: index,
        use: z.enum(['avoidable', 'replaceable', 'needed', 'unknown']),
        run: runFound.nullable(),
      }),
    ),
  }),
  forecast: forecastReportSchema.nullable().describe('What the uncalibrated model of players expects who aim at the run.'),
  curve: z
    .array(z.strictObject({ sigma: z.number(), p: share, low: share, high: share, samples: z.int() }))
    .describe('Success at more noises, with --svg.'),
});

/** The zod schema of what `gq difficulty` prints as JSON. */
export const difficultyReportSchema = z.strictObject({
  version,
  levels: z.array(
    z.strictObject({
      file: z.string(),
      name: z.string(),
      terms: termsReportSchema,
      problems: z.array(problem),
      measured: measuredDifficulty.nullable(),
      why: z.string().nullable().describe('Why nothing was measured.'),
      players: playersReportSchema.optional(),
    }),
  ),
  packs: z
    .array(
      z.strictObject({
        file: z.string(),
        name: z.string(),
        levels: z.array(z.string()).describe('The files of the listed levels, in the order in which they are played.'),
        jumps: z
          .array(
            z.strictObject({
              file: z.string(),
              after: z.string().describe('The file of the hardest level before it.'),
              by: z.number().describe('By how much its grade is above the highest grade before it.'),
            }),
          )
          .describe('Levels that are much harder than all before them.'),
      }),
    )
    .optional()
    .describe('The curve of difficulty of each folder with a pack.json; left out if there is none.'),
  plays: playsReportSchema.optional(),
});

/** What `gq difficulty` prints as JSON. */
export type DifficultyReport = z.infer<typeof difficultyReportSchema>;

/** The zod schema of what `gq generate` prints as JSON. */
export const generateReportSchema = z.strictObject({
  version,
  asked: z.int().min(1).describe('Levels asked for.'),
  levels: z.array(
    z.strictObject({
      seed: z.int(),
      status: z
        .enum(['written', 'unchanged', 'in the way', 'nothing'])
        .describe('unchanged: there already; in the way: another file of that name, which stays; nothing: none was good enough.'),
      file: z.string().nullable(),
      name: z.string().nullable(),
      grade: z.strictObject({ value: z.number(), word: z.string() }).nullable(),
      p40: share.nullable(),
      certifiedTicks: z.int().nullable(),
      length: time.nullable(),
      presses: z.int().nullable(),
      attempts: z.int().describe('Layouts tried.'),
      ticks: z.int().describe('Simulated, of 1/60 s each.'),
      theme: z
        .strictObject({
          name: z.string(),
          measured: z.string().describe('What is measured, in words.'),
          value: z.number(),
          least: z.number().describe('The least that a level of the theme measures.'),
        })
        .nullable()
        .describe('How much the level is of the theme that was asked for; null without a theme.'),
      symmetry: z
        .strictObject({ kind: z.string(), share: share.describe('The share of novae that have a counterpart.') })
        .nullable()
        .describe('How symmetric the novae are; null where no symmetry was asked for.'),
      aside: z.int().nullable().describe('Minerals that the run "solution" does not collect, and another run does.'),
    }),
  ),
  terms: termsReportSchema.describe('Under which the levels are completable. Rules are written into the levels.'),
  rejected: z.int().min(0).describe('Layouts that were thrown away.'),
  reasons: z
    .record(z.string(), z.int().min(0))
    .describe(
      'How many layouts were thrown away for each reason: noRoom, noRun, noDetour, offTheme, asymmetric, tooEasy, tooHard, unforgiving, noMinerals, outOfTerms, warnings; and alike in a pack.',
    ),
  variety: z
    .strictObject({
      mean: share.describe('The mean distance between two levels: 0 the same up to symmetry, 1 nothing in common.'),
      closest: z.strictObject({ distance: share, seeds: z.tuple([z.int(), z.int()]) }).describe('The two most similar levels.'),
    })
    .nullable()
    .describe('How much the levels differ; null for fewer than two.'),
  pack: z
    .strictObject({ file: z.string(), status: z.enum(['written', 'unchanged', 'in the way']) })
    .optional()
    .describe('The pack.json with the order of the levels; only with --pack.'),
});

/** What `gq generate` prints as JSON. */
export type GenerateReport = z.infer<typeof generateReportSchema>;
