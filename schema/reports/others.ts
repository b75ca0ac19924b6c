import * as z from 'zod';
import { runReportSchema, VERDICTS } from './check.ts';
import { problem, termsReportSchema, version } from './parts.ts';

const { holds, outcome, time } = runReportSchema.shape;
const effect = z.strictObject({ name: z.string(), because: z.string().describe('Why it is simulated, or why not.') });
const count = z.int().min(0);

/** The zod schema of what `gq inspect` prints as JSON. */
export const inspectReportSchema = z.strictObject({
  version,
  level: z.string(),
  terms: termsReportSchema,
  effects: z.strictObject({ simulated: z.array(effect), notCalledFor: z.array(effect) }),
  counts: z.record(z.string(), count).describe('Objects of each kind, and runs.'),
  modes: z
    .array(z.strictObject({ name: z.string(), share: z.number().min(0).max(1) }))
    .describe("Shares of the first run's time in each mode of motion; empty without a run."),
  work: z
    .strictObject({ pieces: count, forceEvaluations: count, guards: count, roots: count })
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
  reference: z.strictObject({
    tolerance: px,
    outcome,
    time,
    floor: px.describe("The reference's own error: a smaller error means no more than that."),
  }),
  methods: z.array(
    z.strictObject({
      name: z.string(),
      integrator: z.string(),
      rate: z.number().optional().describe('Hz; only of an integrator with fixed steps.'),
      tolerance: z.number().nullable().optional().describe('px; only of an integrator with error control.'),
      contact: z.string(),
      error: px.describe("The largest distance from the reference's path, px."),
      cost: microseconds,
      medianCost: microseconds,
      outcome,
      time,
      sameVerdict: z.boolean().describe("Whether the outcome is the reference's."),
    }),
  ),
  cheapest: z
    .strictObject({ below: px, name: z.string().nullable().describe('null: none') })
    .describe("The cheapest setting with the reference's outcome and an error below that."),
});

/** What `gq accuracy` prints as JSON. */
export type AccuracyReport = z.infer<typeof accuracyReportSchema>;

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
