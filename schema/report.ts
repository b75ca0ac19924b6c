import * as z from 'zod';

/** The verdicts on a level; those after the first need attention. */
export const VERDICTS = ['completable', 'broken', 'unproven', 'impossible', 'invalid', 'crashed'] as const;

export type Verdict = (typeof VERDICTS)[number];

const time = z.number().min(0).describe('Seconds from the start.');
const index = z.int().min(0).describe("Within the level's own list of that kind, from 0.");
const kind = z.enum(['nova', 'asteroid', 'alien', 'blackHole']);

/** What `simulate` prints as JSON: one run. */
export const runReportSchema = z.strictObject({
  level: z.string(),
  accuracy: z.string(),
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
    .describe('The nearest she came to something deadly.'),
  final: z.strictObject({ x: z.number(), y: z.number(), vx: z.number(), vy: z.number(), angle: z.number() }),
  samples: z
    .array(z.tuple([z.number(), z.number(), z.number(), z.number(), z.number(), z.number()]))
    .describe('[t, x, y, vx, vy, angle]'),
  hash: z.string().describe('Covers every sample, event and the final state bit for bit.'),
});

/** One run, as `simulate` prints it. */
export type RunReport = z.infer<typeof runReportSchema>;

const problem = z.strictObject({
  code: z.string(),
  severity: z.enum(['error', 'warning']),
  message: z.string(),
  line: z.int().min(1).nullable(),
  column: z.int().min(1).nullable(),
  pointer: z.string().describe("JSON pointer; '' is the whole file."),
});

const levelReport = z.strictObject({
  file: z.string(),
  name: z.string(),
  verdict: z.enum(VERDICTS),
  run: runReportSchema.nullable(),
  problems: z.array(problem),
  ms: z.number().min(0),
});

/** What `check` prints as JSON: one entry a level, and how many have which verdict. */
export const checkReportSchema = z.strictObject({
  levels: z.array(levelReport),
  summary: z.partialRecord(z.enum(VERDICTS), z.int().min(0)),
});

/** One level, as `check` reports it. */
export type LevelReport = z.infer<typeof levelReport>;

/** What `check` prints. */
export type CheckReport = z.infer<typeof checkReportSchema>;
