import * as z from 'zod';
import { RULE_NAMES, VERDICTS } from '../basics/index.ts';
import { runReportSchema } from './check.ts';
import { playVerdict, problem, termsReportSchema, version } from './parts.ts';

const { holds, outcome, time } = runReportSchema.shape;
const effect = z.strictObject({ name: z.string(), because: z.string().describe('Why it is simulated, or why not.') });
const count = z.int().min(0);
const measured = z.number().min(0).optional().describe('With --time: microseconds per simulated second.');
const simulatedEffect = effect.extend({
  work: z
    .strictObject({
      guards: count.describe('Guards of its events that were followed.'),
      roots: count.describe('Roots of these guards that were located.'),
      events: count.describe('Its events that happened.'),
      time: measured,
    })
    .nullable()
    .describe('What it costs in the first run; null without a run and under arcade.'),
});

/** The zod schema of what `gq inspect` prints as JSON. */
export const inspectReportSchema = z.strictObject({
  version,
  level: z.string(),
  terms: termsReportSchema,
  effects: z.strictObject({ simulated: z.array(simulatedEffect), notCalledFor: z.array(effect) }),
  counts: z.record(z.string(), count).describe('Objects of each kind, and runs.'),
  modes: z
    .array(z.strictObject({ name: z.string(), share: z.number().min(0).max(1) }))
    .describe("Shares of the first run's time in each mode of motion; empty without a run."),
  work: z
    .strictObject({ pieces: count, forceEvaluations: count, guards: count, roots: count, time: measured })
    .describe('What the first run costs; 0 without a run.'),
  problems: z.array(problem),
});

/** What `gq inspect` prints as JSON. */
export type InspectReport = z.infer<typeof inspectReportSchema>;

const microseconds = z.number().min(0).describe('Microseconds per simulated second.');
const px = z.number().min(0).describe('px');

/** The zod schema of what `gq accuracy` prints as JSON. */
export const accuracyReportSchema = z.strictObject({
  version,
  level: z.string(),
  terms: termsReportSchema,
  holds,
  reference: z
    .strictObject({
      method: z
        .string()
        .describe('How it was computed: by other methods than all that is measured, unless `doubt` says otherwise.'),
      tolerance: px.describe('How far a step of it may be from the truth, px.'),
      outcome,
      time,
      knownTo: px
        .nullable()
        .describe(
          'The distance to a second reference of yet another method, px: a smaller error means no more than that. null: see `doubt`.',
        ),
      doubt: z.string().nullable().describe('Why there are no two references that end alike; null if there are.'),
    })
    .describe('The run that all others are compared with.'),
  methods: z.array(
    z.strictObject({
      name: z.string(),
      integrator: z.string(),
      rate: z.number().optional().describe('Hz; only of an integrator with fixed steps.'),
      tolerance: z.number().nullable().optional().describe('px; only of an integrator with error control.'),
      contact: z.string(),
      error: px.describe("The largest distance from the reference's path, px."),
      cost: microseconds,
      costSpread: z
        .tuple([microseconds, microseconds])
        .describe('The least of the measurements, which is the cost, and their upper quartile.'),
      rounds: count.optional().describe('How often it was timed, where that is fewer than 5 times: the time was used up.'),
      outcome,
      time,
      sameVerdict: z.boolean().describe("Whether the outcome is the reference's."),
    }),
  ),
  unmeasured: z
    .array(
      z.strictObject({ name: z.string(), time: time.describe('Until when it was played, s.'), why: z.enum(['work', 'time']) }),
    )
    .describe('Settings whose run takes more work than the terms allow, or that no time was left for.'),
  cheapest: z
    .strictObject({ name: z.string(), below: px, error: px, cost: microseconds })
    .nullable()
    .describe("The cheapest setting with the reference's outcome and an error below that; null: none."),
});

/** What `gq accuracy` prints as JSON. */
export type AccuracyReport = z.infer<typeof accuracyReportSchema>;

const ofRun = { file: z.string(), run: z.string().describe("The run's name.") };

/** The zod schema of what `gq accuracy --cheapest` prints as JSON. */
export const cheapestReportSchema = z.strictObject({
  version,
  terms: termsReportSchema,
  runs: count.describe('How many runs had to stay as they are.'),
  tried: z
    .array(
      z.strictObject({
        name: z.string(),
        cost: microseconds,
        costSpread: z.tuple([microseconds, microseconds]),
        broken: z
          .strictObject({ ...ofRun, what: z.string() })
          .nullable()
          .describe('The first run that is not kept, and what is different; null: all are kept.'),
        error: z
          .strictObject({ ...ofRun, px })
          .nullable()
          .describe('The largest error of any run.'),
        tightest: z
          .strictObject({ ...ofRun, share: z.number().min(0) })
          .nullable()
          .describe("The largest share of a run's clearance that its error takes; null where nothing deadly is near any run."),
      }),
    )
    .describe('From the cheapest setting on, up to the first that keeps all runs.'),
  untried: z.array(z.string()).describe('Where no setting was found: those that were not tried, as the time was used up.'),
  cheapest: z.string().nullable().describe('The first setting that keeps all runs; null: none of those that were tried does.'),
  doubts: z.array(z.strictObject({ ...ofRun, doubt: z.string() })).describe('Runs whose reference no second one confirms.'),
});

/** What `gq accuracy --cheapest` prints as JSON. */
export type CheapestReport = z.infer<typeof cheapestReportSchema>;

const code = z.strictObject({
  code: z.string(),
  severity: z.enum(['error', 'warning']),
  title: z.string(),
  why: z.string(),
  fix: z.string(),
  example: z.string().optional(),
});
const proof = z.strictObject({ code: z.string(), title: z.string(), why: z.string(), fix: z.string(), see: z.string() });

/** The zod schema of what `gq explain` prints as JSON: a problem, a kind of proof, or all of them. */
export const explainReportSchema = z.union([
  z.strictObject({ version, ...code.shape }).describe('A problem.'),
  z.strictObject({ version, ...proof.shape }).describe('A kind of proof.'),
  z.strictObject({ version, codes: z.array(code), proofs: z.array(proof) }).describe('Without a code: all of them.'),
]);

/** What `gq explain` prints as JSON. */
export type ExplainReport = z.infer<typeof explainReportSchema>;

/** The zod schema of what `gq fmt` prints as JSON. */
export const fmtReportSchema = z.strictObject({
  version,
  files: z.array(
    z.strictObject({
      file: z.string(),
      status: z
        .enum(['unchanged', 'formatted', 'would change', 'invalid', 'failed'])
        .describe('would change: with --check; failed: it could not be read or written, and is unchanged.'),
      problems: z.array(problem),
    }),
  ),
});

/** What `gq fmt` prints as JSON. */
export type FmtReport = z.infer<typeof fmtReportSchema>;

/** The zod schema of what `gq import` prints as JSON. */
export const importReportSchema = z.strictObject({
  version,
  files: z.array(
    z.strictObject({
      file: z.string(),
      level: z.string().describe("The level's name."),
      status: z.enum(['written', 'overwritten', 'unchanged']),
    }),
  ),
  notes: z.array(z.string()).describe('What was skipped or ignored.'),
});

/** What `gq import` prints as JSON. */
export type ImportReport = z.infer<typeof importReportSchema>;

/** The zod schema of what `gq export` prints as JSON. */
export const exportReportSchema = z.strictObject({
  version,
  files: z.array(
    z.strictObject({
      file: z.string(),
      levels: z.array(z.string()).describe('The level files that are in it.'),
      status: z.enum(['written', 'overwritten', 'unchanged']),
    }),
  ),
  warnings: z
    .array(z.strictObject({ file: z.string().describe('The level file.'), message: z.string() }))
    .describe('What the other format does not say.'),
});

/** What `gq export` prints as JSON. */
export type ExportReport = z.infer<typeof exportReportSchema>;

/** The zod schema of what `gq init` prints as JSON. */
export const initReportSchema = z.strictObject({
  version,
  dryRun: z.boolean().describe('Whether nothing was written.'),
  ci: z.enum(['github', 'gitlab', 'none']),
  files: z.array(
    z.strictObject({
      file: z.string(),
      status: z.enum(['written', 'changed', 'unchanged', 'left']).describe('left: it exists, and is as it was.'),
      note: z.string().nullable().describe('Why it was left, or what else to do.'),
    }),
  ),
  next: z.array(z.string()).describe('What to do next: commands.'),
});

/** What `gq init` prints as JSON. */
export type InitReport = z.infer<typeof initReportSchema>;

/** The zod schema of what `gq build` prints as JSON. */
export const buildReportSchema = z.strictObject({
  version,
  written: z.boolean().describe('false: levels were refused, and nothing has changed.'),
  site: z.string().describe('The folder.'),
  title: z.string(),
  levels: z
    .array(
      z.strictObject({
        id: z.string().describe('The name under which the page keeps progress.'),
        file: z.string(),
        name: z.string(),
        terms: termsReportSchema,
        verdict: z.enum(VERDICTS),
        refused: z.boolean().describe('Whether nothing was written because of this level.'),
        problems: z.array(problem),
      }),
    )
    .describe('In the order of play.'),
  leftOut: z.array(z.string()).optional().describe('The ids of levels that pack.json does not list; left out if there are none.'),
  files: z.array(
    z.strictObject({
      file: z.string(),
      status: z
        .enum(['written', 'overwritten', 'unchanged', 'removed'])
        .describe('removed: of an earlier build, and this one does not have it.'),
      bytes: count,
    }),
  ),
  bytes: count.describe('Of all files.'),
  gzipped: count.describe('Bytes of all files as a server sends them; 0 when nothing was written.'),
});

/** What `gq build` prints as JSON. */
export type BuildReport = z.infer<typeof buildReportSchema>;

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
